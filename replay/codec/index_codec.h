#pragma once

#include <cstdint>
#include <vector>

#include "replay/codec/zstd_frame.h"
#include "src/base/hash.h"
#include "src/base/result.h"

namespace tumble::replay {

/// Where a chunk is and what it holds: a row of the index, which a scan over the preludes finds as well.
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

Result<MessageBytes> encode_index(const std::vector<ChunkPlace>& chunks);
Result<std::vector<ChunkPlace>> decode_index(const MessageBytes& message);

}  // namespace tumble::replay
