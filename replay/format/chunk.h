#pragma once

#include <cstdint>
#include <vector>

#include "tumble/replay/step_record.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/world_state.h"

namespace tumble::replay {

/// A complete state with its hidden parts, from which a session can continue.
struct Keyframe {
  sim::WorldState state;
  Hash128 continuation_hash;  ///< sim::continuation_hash of `state`, by the build that wrote the log
};

/// Consecutive steps, and a keyframe: the state before the inputs of the first step are applied.
struct Chunk {
  Keyframe keyframe;
  std::uint64_t first_step = 1;
  std::vector<StepRecord> steps;
};

/// The place and the content of a chunk record: one row of the index. The prelude of the chunk holds all
/// these values but the offset.
struct ChunkPlace {
  std::uint64_t offset = 0;      ///< of the record's prelude
  std::uint64_t length = 0;      ///< of the record, prelude included
  std::uint64_t first_step = 0;  ///< 1 …
  std::uint64_t step_count = 0;
  Hash128 chain_after;
  Hash128 stored_hash;
  [[nodiscard]] std::uint64_t end_step() const { return first_step + step_count; }  ///< first step of the next chunk
  friend bool operator==(const ChunkPlace&, const ChunkPlace&) = default;
};

}  // namespace tumble::replay
