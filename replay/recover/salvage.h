#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "replay/format/step_record.h"
#include "replay/log/byte_io.h"
#include "replay/log/log_condition.h"
#include "replay/recover/salvage_choice.h"
#include "src/base/result.h"

namespace tumble::replay {

struct SavedHeader {
  Prelude prelude;            ///< as it was written; made anew where it was damaged
  std::uint64_t payload = 0;  ///< offset of its stored bytes in the damaged file
  LogHeader content;
};

/// What is left of a session in a damaged file.
struct Salvage {
  std::optional<SavedHeader> header;
  std::vector<SavedChunk> chunks;          ///< ascending, see choose_chunks()
  std::optional<std::uint64_t> last_step;  ///< of the session when it was written, where index or footer are there
  std::uint64_t lost_bytes = 0;            ///< of the file, that belong to nothing that was saved and to no second copy
  std::vector<Damage> damages;             ///< by offset: what is not kept, or was kept in spite of damage
};

/// Looks through a damaged file for everything that is whole: records anywhere, in any order, and zstd frames whose
/// prelude was damaged. Every chunk that is kept was decoded and its chain and states compared with their hashes. Of
/// several sessions in one file it takes the one whose header is there and that has the most steps. Errors: kBadInput
/// for what was never a log or needs a newer program; kCannotFinish for memory. A file without a whole chunk is no
/// error.
Result<Salvage> salvage(const ByteSource& source);

}  // namespace tumble::replay
