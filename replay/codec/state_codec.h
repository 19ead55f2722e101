#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "replay/codec/state_keys.h"
#include "replay/codec/state_rows.h"
#include "schema/log.capnp.h"
#include "tumble/replay/body_states.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"

/// Codec 1 of docs/log_format.md: stores the states of a chunk, column by column, as differences from the prediction of
/// codec1_predictor.h. Lossless for all doubles: a column with a value off its grid stores differences of bit patterns.
/// Included by codecs only.
namespace tumble::replay {

inline constexpr std::uint16_t kStateCodec = 1;

/// The columns of a chunk's states before they become a message.
struct StateColumns {
  std::vector<std::uint8_t> flags;
  std::array<bool, kColumnCount> on_grid = {};
  std::array<std::vector<std::uint64_t>, kColumnCount> residuals;
};

/// Encodes the states of a chunk, step by step, into its own memory, so that the message can be allocated in the right
/// size; then copies into the message.
class StateEncoder {
 public:
  /// Begins a chunk. keyframe: must stay until the last step was added.
  void begin(const sim::WorldState& keyframe);

  /// Adds the step after those in `earlier`, which are the chunk's so far and need no states. Errors (kCannotFinish):
  /// the step has other bodies than keyframe and inputs lead to, or `frozen` is not 0 or 1, so the records are no
  /// session.
  Status add(const StepRecord& record, std::span<const StepRecord> earlier);
  /// Likewise, without copying: record.states is then of no use.
  Status take(StepRecord& record, std::span<const StepRecord> earlier);

  [[nodiscard]] std::size_t bytes() const { return out_.flags.size() + out_.residuals[0].size() * 8 * kColumnCount; }
  void copy_to(schema::States::Builder out) const;

 private:
  Status encode(const StepRecord& record, std::span<const StepRecord> earlier);
  Status encode_step(const StepRecord& record);
  void encode_body(const BodyStates& states, std::size_t i);
  Status leave_grids(const StepRecord& record, std::span<const StepRecord> earlier);

  const sim::WorldState* keyframe_ = nullptr;
  std::optional<StateRows> rows_;
  double dt_ = 0;  // since the state stored last
  StateColumns out_;
};

/// Decodes the states of a chunk, step by step. Copies the data, so the message need not outlive the decoder.
class StateDecoder {
 public:
  StateDecoder(const sim::WorldState& keyframe, schema::States::Reader in);
  /// Of what an encoder has made so far.
  StateDecoder(const sim::WorldState& keyframe, StateColumns columns);

  /// Checks the sizes; call once before decode(). Errors. kDamaged: sizes that contradict each other, more states than
  /// limits.h allows in a chunk of step_count steps. kBadInput: an unknown codec.
  [[nodiscard]] Status check(std::size_t step_count) const;

  /// Fills record.states if record.has_states. Call for each record once, in order; reads step, dt and inputs of the
  /// record. Errors (kDamaged): fewer states are stored than the records need, or an input is impossible.
  Status decode(StepRecord& record);

 private:
  void decode_body(BodyStates& states, std::size_t i, std::uint8_t flag);
  codec1::Row decode_row(const codec1::Motion& before, bool frozen);

  StateRows rows_;
  std::uint16_t codec_;
  std::size_t column_count_ = 0;
  StateColumns in_;
  bool sizes_agree_ = true;
  std::size_t next_flag_ = 0;
  std::size_t next_residual_ = 0;
  double dt_ = 0;  // since the state stored last
};

}  // namespace tumble::replay
