#pragma once

#include <cstdint>
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

/// Searches for an intact record at every byte of a file. The work is limited by kSalvageWork times the size of the
/// file: records that contain one another, which no writer produces, count as scraps once they cost more.
Pieces find_pieces(const ByteSource& source);

}  // namespace tumble::replay
