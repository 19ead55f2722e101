#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "replay/codec/zstd_frame.h"
#include "src/base/check.h"
#include "tumble/replay/chunk.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

class StateEncoder;
class StateDecoder;

/// Whether any of the steps has extras, which need format version 2.0.
bool has_extras(std::span<const StepRecord> steps);

/// Encodes chunk messages. Uses its memory again for the next chunk.
class ChunkEncoder {
 public:
  ChunkEncoder();
  ~ChunkEncoder();

  /// types: of the channels of the log. Errors (kCannotFinish): out of memory; a state has other bodies than keyframe
  /// and inputs lead to.
  Result<MessageBytes> encode(const Keyframe& keyframe, std::span<const StepRecord> steps,
                              const std::vector<ChannelType>& types = {});

  /// The three parts of encode(), for steps that come one by one. The state of the keyframe must stay until finish().
  void begin(const sim::WorldState& keyframe);
  /// Encodes the states of the step after those in `earlier`, which need no states; takes them from the record.
  Status take_states(StepRecord& step, std::span<const StepRecord> earlier);
  /// keyframe: that of begin(). steps: all of the chunk; they need no states.
  Result<MessageBytes> finish(const Keyframe& keyframe, std::span<const StepRecord> steps,
                              const std::vector<ChannelType>& types);

  /// Takes back the memory of a message that is needed no longer, for the next one.
  void take_back(MessageBytes message) { spare_ = std::move(message); }

 private:
  MessageBytes spare_;
  std::unique_ptr<StateEncoder> states_;
};

/// Decodes a chunk message. Opening decodes everything but the states. step() decodes states up to the requested step
/// and keeps them, so that reading a whole chunk decodes each state once, and reading hashes decodes none.
class ChunkDecoder {
 public:
  /// Errors name neither file nor offset. kDamaged: a value that no writer produces. kBadInput: a method, an input or a
  /// codec that this build does not know.
  static Result<ChunkDecoder> open(const MessageBytes& message);
  ChunkDecoder(ChunkDecoder&&) noexcept;
  ChunkDecoder& operator=(ChunkDecoder&&) noexcept;
  ~ChunkDecoder();

  [[nodiscard]] const Keyframe& keyframe() const { return chunk_.keyframe; }
  [[nodiscard]] std::uint64_t first_step() const { return chunk_.first_step; }
  [[nodiscard]] std::size_t step_count() const { return chunk_.steps.size(); }

  /// Whether any step has extras; see has_extras().
  [[nodiscard]] bool has_extras() const { return replay::has_extras(chunk_.steps); }

  /// The channels that have values in the chunk, by index, with their types.
  [[nodiscard]] const std::vector<std::pair<std::size_t, ChannelType>>& channels() const { return channels_; }

  /// Step first_step() + index. Its states are empty until step() has decoded them.
  [[nodiscard]] const StepRecord& without_states(std::size_t index) const {
    SIM_CHECK(index < chunk_.steps.size(), index, chunk_.steps.size());
    return chunk_.steps[index];
  }

  /// Step first_step() + index with its states, where the log has them. Errors: kDamaged.
  Result<const StepRecord*> step(std::size_t index);

 private:
  ChunkDecoder();

  Chunk chunk_;
  std::vector<std::pair<std::size_t, ChannelType>> channels_;
  std::unique_ptr<StateDecoder> states_;
  std::size_t decoded_ = 0;  // steps whose states are there
};

}  // namespace tumble::replay
