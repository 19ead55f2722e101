#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "replay/recover/salvage_choice.h"
#include "replay/recover/salvage_pieces.h"
#include "tumble/replay/byte_io.h"
#include "tumble/replay/log_condition.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// A header record that was found intact, or an intact header message whose prelude was damaged.
struct SavedHeader {
  Prelude prelude;            ///< as written; rebuilt where it was damaged
  std::uint64_t payload = 0;  ///< offset of the stored bytes in the damaged file
  LogHeader content;
};

/// The parts of one session that are intact in a damaged file.
struct Salvage {
  std::optional<SavedHeader> header;
  std::vector<SavedChunk> chunks;          ///< ascending; see choose_chunks()
  std::optional<std::uint64_t> last_step;  ///< of the session, if index or footer is intact
  std::uint64_t lost_bytes = 0;            ///< bytes of the file outside saved records and second copies
  OtherParts others;
  std::vector<Damage> damages;  ///< by offset: discarded records, and records saved despite damage
};

/// Searches a damaged file for intact parts: records at any offset and in any order, and zstd frames whose prelude was
/// damaged. Decodes each chunk and compares its chain and its states with the hashes before saving it. In a file with
/// several sessions, chooses the one whose header stands at the file's start; where that has no chunk left, one with an
/// intact header, and of these the one with the most steps.
///
/// Errors. kBadInput: the log needs a newer program. kCannotFinish: reading fails, out of memory. A file without an
/// intact chunk is no error.
Result<Salvage> salvage(const ByteSource& source);

}  // namespace tumble::replay
