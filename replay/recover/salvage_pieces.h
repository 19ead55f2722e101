#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tumble/replay/byte_io.h"
#include "tumble/replay/prelude.h"

namespace tumble::replay {

/// A record of any log with intact prelude and intact stored bytes.
struct Piece {
  std::uint64_t offset = 0;  ///< of the prelude
  Prelude prelude;
};

/// Bytes outside intact records: begin ≤ byte < end.
struct Scrap {
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
};

/// The intact records of a file and the bytes between them.
struct Pieces {
  std::vector<Piece> records;  ///< by offset; headers, chunks, indices
  std::vector<Piece> footers;
  std::vector<Scrap> scraps;  ///< by offset
};

/// Intact parts of a file that are not of the session that is saved.
struct OtherParts {
  std::uint64_t records = 0;       ///< of other logs
  std::uint64_t logs = 0;          ///< which they belong to
  std::uint64_t steps = 0;         ///< in these records
  std::uint64_t unfit_chunks = 0;  ///< with the session's header, but of another session or out of place
  std::uint64_t unfit_steps = 0;
};

/// Searches for an intact record at every byte of a file. The work is limited by kSalvageWork times the size of the
/// file: records that contain one another, which no writer produces, count as scraps once they cost more.
Pieces find_pieces(const ByteSource& source);

/// Counts the records of other logs than that of `tag`.
OtherParts parts_of_others(const Pieces& pieces, std::uint64_t tag);

/// "182 bytes from byte 7000 on are part of no whole record"; says which record the file's end cuts off there.
std::string scrap_text(const ByteSource& source, const Scrap& scrap);

}  // namespace tumble::replay
