#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "src/base/result.h"

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

namespace tumble::replay {

/// Bytes aligned as Cap'n Proto wants them. The memory is not cleared first, so that a size that a file merely claims
/// costs nothing until the bytes are there.
class MessageBytes {
 public:
  MessageBytes() = default;
  /// bytes: a multiple of 8.
  explicit MessageBytes(std::size_t bytes)
      : words_(std::make_unique_for_overwrite<std::uint64_t[]>(bytes / 8)), bytes_(bytes) {}

  [[nodiscard]] std::span<std::byte> bytes() { return {reinterpret_cast<std::byte*>(words_.get()), bytes_}; }
  [[nodiscard]] std::span<const std::byte> bytes() const {
    return {reinterpret_cast<const std::byte*>(words_.get()), bytes_};
  }

 private:
  std::unique_ptr<std::uint64_t[]> words_;
  std::size_t bytes_ = 0;
};

/// Makes one zstd frame of a message, with its size and a checksum in it. Logs take level 1: level 3 gains 4 % at
/// two thirds of the speed (docs/log_format.md).
class Compressor {
 public:
  /// window_log: matches reach back at most 2^window_log bytes, and no block is longer; 0: as the level has it.
  explicit Compressor(int level = 1, int window_log = 0);
  ~Compressor();
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;

  /// Replaces `out` with the frame. Errors: memory.
  Status compress(std::span<const std::byte> raw, std::vector<std::byte>& out);

 private:
  ZSTD_CCtx_s* context_;
};

/// How long a zstd frame is and what it decompresses to, both by its own account.
struct FrameSize {
  std::size_t stored_bytes = 0;
  std::uint64_t raw_bytes = 0;
};

/// The frame that begins with the first of `bytes`, more of which may follow it; none if none does, it is cut, or does
/// not say its size.
std::optional<FrameSize> frame_at(std::span<const std::byte> bytes);

/// The message in a frame. raw_bytes is what the prelude says; a frame that says otherwise is damaged. Errors carry
/// neither file nor offset.
Result<MessageBytes> decompress(std::span<const std::byte> frame, std::uint64_t raw_bytes, std::uint64_t limit);

}  // namespace tumble::replay
