#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "replay/format/prelude.h"
#include "src/base/hash.h"

namespace tumble::replay {

/// A chunk that survives, every state of it compared with its hash.
struct SavedChunk {
  Prelude prelude;            ///< as it was written; made anew where it was damaged
  std::uint64_t payload = 0;  ///< offset of its stored bytes in the damaged file
  bool chain_known = true;    ///< false: the prelude was lost, so what came before the chunk has to say the chain
  Hash128 keyframe_hash;      ///< state hash of its keyframe
  Hash128 final_hash;         ///< state hash after its last step
  Hash128 continuation_hash;  ///< of its keyframe, as the log has it

  [[nodiscard]] std::uint64_t first_step() const { return prelude.first_step; }
  [[nodiscard]] std::uint64_t end_step() const { return prelude.first_step + prelude.step_count; }
};

/// Where a session begins, as far as it is known.
struct SessionStart {
  std::uint64_t first_step = 1;
  std::optional<Hash128> chain;         ///< before that step
  std::optional<Hash128> continuation;  ///< continuation hash of the state before it, of a session that goes on
};

/// The chain after a chunk whose prelude was lost, from the chain before it; none if the chunk cannot be read.
using ChainAfter = std::function<std::optional<Hash128>(const SavedChunk&, const Hash128& before)>;

/// The chunks that together hold the most steps of one session: none twice, and where one begins with the step after
/// another, chain and state fit. Puts the chain into those that lacked it. Equal sums: the fewest gaps, then the
/// earliest in the file.
std::vector<SavedChunk> choose_chunks(std::vector<SavedChunk> candidates, const SessionStart& start,
                                      const ChainAfter& chain_after);

}  // namespace tumble::replay
