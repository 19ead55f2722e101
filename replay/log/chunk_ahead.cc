#include "replay/log/chunk_ahead.h"

#include <system_error>

namespace tumble::replay {

void ChunkAhead::begin(std::size_t chunk, const ChunkPlace& place) {
  chunk_ = chunk;
  try {
    decoder_ = std::async(std::launch::async, [this, place] { return records_.read_chunk(place, rules_); });
  } catch (const std::system_error&) {
    decoder_ = {};
  }
}

std::optional<Result<ChunkDecoder>> ChunkAhead::take(std::size_t chunk) {
  if (!decoder_.valid()) return std::nullopt;
  Result<ChunkDecoder> decoder = decoder_.get();
  if (chunk != chunk_) return std::nullopt;
  return decoder;
}

}  // namespace tumble::replay
