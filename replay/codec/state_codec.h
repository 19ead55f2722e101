#pragma once

#include <span>
#include <vector>

#include "replay/codec/state_keys.h"
#include "replay/codec/state_rows.h"
#include "replay/format/body_states.h"
#include "replay/format/step_record.h"
#include "schema/log.capnp.h"
#include "src/base/result.h"

/// Codec 1 of docs/log_format.md: the states of a chunk as residuals against codec1_predictor.h, column by column.
/// Lossless for any doubles: a column with a value off its grid stores differences of bit patterns instead. Included by
/// codecs only.
namespace tumble::replay {

inline constexpr std::uint16_t kStateCodec = 1;

/// A chunk's states, packed; made first, so that the message can be sized, then copied into it.
class StateEncoder {
 public:
  /// records: the steps after the keyframe, in order. Errors (kCannotFinish): the bodies of a state are not those that
  /// keyframe and inputs imply, or `frozen` is not 0 or 1: the caller logged something else than a session.
  Status encode(const sim::WorldState& keyframe, std::span<const StepRecord> records);

  [[nodiscard]] std::size_t bytes() const { return flags_.size() + residuals_[0].size() * 8 * kColumnCount; }
  void copy_to(schema::States::Builder out) const;

 private:
  Status encode_step(const StateRows& rows, const StepRecord& record, double dt);
  void encode_body(const StateRows& rows, const BodyStates& states, std::size_t i, double dt);
  void choose_grids(std::span<const StepRecord> records);

  std::vector<std::uint8_t> flags_;
  std::array<bool, kColumnCount> on_grid_ = {};
  std::array<std::vector<std::uint64_t>, kColumnCount> residuals_;
};

/// Unpacks a chunk's states step by step. Owns what it needs; the message may go.
class StateDecoder {
 public:
  StateDecoder(const sim::WorldState& keyframe, schema::States::Reader in);

  /// Errors (kDamaged, kBadInput): sizes that do not fit together, more states than limits.h allows in a chunk of
  /// step_count steps, a codec that is not known. Call once before decode().
  [[nodiscard]] Status check(std::size_t step_count) const;

  /// Fills record.states if record.has_states. Records must come in order, each once; step, dt and inputs are read.
  /// Errors (kDamaged): more states than were stored, an input that cannot be.
  Status decode(StepRecord& record);

 private:
  void decode_body(BodyStates& states, std::size_t i, std::uint8_t flag);
  codec1::Row decode_row(const codec1::Motion& before, bool frozen);

  StateRows rows_;
  std::uint16_t codec_;
  std::size_t column_count_ = 0;
  std::vector<std::uint8_t> flags_;
  std::array<bool, kColumnCount> on_grid_ = {};
  std::array<std::vector<std::uint64_t>, kColumnCount> residuals_;
  bool sizes_agree_ = true;
  std::size_t next_flag_ = 0;
  std::size_t next_residual_ = 0;
  double dt_ = 0;  // since the state stored last
};

}  // namespace tumble::replay
