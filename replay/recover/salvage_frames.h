#pragma once

#include <cstdint>
#include <vector>

#include "replay/codec/zstd_frame.h"
#include "replay/recover/salvage_pieces.h"

namespace tumble::replay {

/// A zstd frame outside every intact record. The frame decompresses and its checksum matches, so only its prelude was
/// damaged.
struct LooseFrame {
  std::uint64_t offset = 0;
  std::uint64_t stored_bytes = 0;
  std::uint64_t raw_bytes = 0;
  Hash128 stored_hash;  ///< of the bytes in the file
};

/// Searches the bytes that find_pieces() left over for frames.
std::vector<LooseFrame> find_frames(const ByteSource& source, const std::vector<Scrap>& scraps);

/// The message in a frame of find_frames().
Result<MessageBytes> read_frame(const ByteSource& source, const LooseFrame& frame);

}  // namespace tumble::replay
