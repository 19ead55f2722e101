#pragma once

#include <cstdint>
#include <vector>

#include "replay/codec/zstd_frame.h"
#include "replay/recover/salvage_pieces.h"

namespace tumble::replay {

/// A zstd frame that decompresses, checksum included, found where no whole record is: its prelude was damaged.
struct LooseFrame {
  std::uint64_t offset = 0;
  std::uint64_t stored_bytes = 0;
  std::uint64_t raw_bytes = 0;
  Hash128 stored_hash;  ///< as found
};

/// Looks for frames in what find_pieces() left over.
std::vector<LooseFrame> find_frames(const ByteSource& source, const std::vector<Scrap>& scraps);

/// The message in a frame that was found.
Result<MessageBytes> read_frame(const ByteSource& source, const LooseFrame& frame);

}  // namespace tumble::replay
