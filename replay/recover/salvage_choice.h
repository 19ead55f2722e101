#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "tumble/replay/extras.h"
#include "tumble/replay/prelude.h"
#include "tumble/sim/hash.h"

namespace tumble::replay {

/// An intact chunk. Each of its states matches its hash.
struct SavedChunk {
  Prelude prelude;            ///< as written; rebuilt where it was damaged
  std::uint64_t payload = 0;  ///< offset of the stored bytes in the damaged file
  bool chain_known = true;    ///< false: the prelude was lost, and with it the chain before the chunk
  Hash128 keyframe_hash;      ///< state hash of the keyframe
  Hash128 final_hash;         ///< state hash after the last step
  Hash128 continuation_hash;  ///< of the keyframe, as the log states it

  [[nodiscard]] std::uint64_t first_step() const { return prelude.first_step; }
  [[nodiscard]] std::uint64_t end_step() const { return prelude.first_step + prelude.step_count; }
};

/// The start of a session, as far as it is known.
struct SessionStart {
  std::uint64_t first_step = 1;
  std::optional<Hash128> chain;         ///< before that step
  std::optional<Hash128> continuation;  ///< of the state before that step, in a continued session
  Extras extras;                        ///< of the state before that step
};

/// Computes the chain after a chunk from the chain before it; none if the chunk cannot be read.
using ChainAfter = std::function<std::optional<Hash128>(const SavedChunk&, const Hash128& before)>;

/// Chooses the chunks that hold the most steps of one session. No step occurs twice, and chain and state match wherever
/// a chunk begins with the step after another. Among equal sums, prefers the fewest runs of missing steps, then the
/// chunks that come first in the file. Fills in the chain of chunks without one.
std::vector<SavedChunk> choose_chunks(std::vector<SavedChunk> candidates, const SessionStart& start,
                                      const ChainAfter& chain_after);

}  // namespace tumble::replay
