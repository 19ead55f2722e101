#pragma once

#include <memory>

#include "replay/codec/zstd_frame.h"
#include "replay/format/chunk.h"
#include "src/base/result.h"

namespace tumble::replay {

class StateEncoder;
class StateDecoder;

/// Makes chunk messages. Keeps its memory from chunk to chunk.
class ChunkEncoder {
 public:
  ChunkEncoder();
  ~ChunkEncoder();

  /// Errors (kCannotFinish): memory, states that the keyframe and the inputs do not lead to.
  Result<MessageBytes> encode(const Keyframe& keyframe, std::span<const StepRecord> steps);

 private:
  std::unique_ptr<StateEncoder> states_;
};

/// A chunk message taken apart. States are decoded up to the step that is asked for and kept, so that going through a
/// chunk costs its decoding once, and a look at its hashes costs none.
class ChunkDecoder {
 public:
  /// Errors without file and offset: kDamaged for what cannot be, kBadInput for what this build does not know.
  static Result<ChunkDecoder> open(const MessageBytes& message);
  ChunkDecoder(ChunkDecoder&&) noexcept;
  ChunkDecoder& operator=(ChunkDecoder&&) noexcept;
  ~ChunkDecoder();

  [[nodiscard]] const Keyframe& keyframe() const { return chunk_.keyframe; }
  [[nodiscard]] std::uint64_t first_step() const { return chunk_.first_step; }
  [[nodiscard]] std::size_t step_count() const { return chunk_.steps.size(); }

  /// Step first_step() + index without its states, which stay empty until step() has been there.
  [[nodiscard]] const StepRecord& without_states(std::size_t index) const { return chunk_.steps[index]; }

  /// The same with its states, where the log has them. Errors: kDamaged.
  Result<const StepRecord*> step(std::size_t index);

 private:
  ChunkDecoder();

  Chunk chunk_;
  std::unique_ptr<StateDecoder> states_;
  std::size_t decoded_ = 0;  // steps whose states are there
};

}  // namespace tumble::replay
