#pragma once

#include <cstdint>
#include <vector>

#include "replay/format/prelude.h"
#include "replay/log/byte_io.h"

namespace tumble::replay {

/// A record whose prelude and stored bytes are as they were written, of whatever log.
struct Piece {
  std::uint64_t offset = 0;  ///< of the prelude
  Prelude prelude;
};

/// Bytes that belong to no such record: begin ≤ byte < end.
struct Scrap {
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
};

struct Pieces {
  std::vector<Piece> records;  ///< by offset; headers, chunks, indices
  std::vector<Piece> footers;
  std::vector<Scrap> scraps;  ///< by offset
};

/// Looks for whole records at every byte of a file. The work is bounded by the file's size: once records that contain
/// each other (which no writer makes) cost too much, the rest of them is left as scraps.
Pieces find_pieces(const ByteSource& source);

}  // namespace tumble::replay
