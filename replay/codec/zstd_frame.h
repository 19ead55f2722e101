#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "src/base/check.h"
#include "tumble/sim/result.h"

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

namespace tumble::replay {

/// Bytes with the alignment that Cap'n Proto needs. The memory is not cleared, so that allocating a size that a file
/// merely claims costs nothing.
class MessageBytes {
 public:
  MessageBytes() = default;
  /// bytes: a multiple of 8.
  explicit MessageBytes(std::size_t bytes) : MessageBytes(bytes, MessageBytes()) {}
  /// In the memory of `spare` where that is enough: pages that were touched before cost nothing again.
  MessageBytes(std::size_t bytes, MessageBytes spare) : MessageBytes(std::move(spare)) {
    SIM_CHECK(bytes % 8 == 0, bytes);
    if (words_ == nullptr || bytes > capacity_) {
      words_.reset();
      words_ = std::make_unique_for_overwrite<std::uint64_t[]>(bytes / 8);
      capacity_ = bytes;
    }
    bytes_ = bytes;
  }

  /// Keeps the first `bytes` bytes.
  void shorten(std::size_t bytes) {
    SIM_CHECK(bytes % 8 == 0 && bytes <= bytes_, bytes, bytes_);
    bytes_ = bytes;
  }

  [[nodiscard]] std::span<std::byte> bytes() { return {reinterpret_cast<std::byte*>(words_.get()), bytes_}; }
  [[nodiscard]] std::span<const std::byte> bytes() const {
    return {reinterpret_cast<const std::byte*>(words_.get()), bytes_};
  }

 private:
  std::unique_ptr<std::uint64_t[]> words_;
  std::size_t bytes_ = 0;
  std::size_t capacity_ = 0;
};

/// Compresses a message to one zstd frame that holds the size and a checksum of the message. Logs use level 1: level 3
/// saves 4 % of the size at two thirds of the speed (docs/log_format.md).
class Compressor {
 public:
  /// window_log: matches reach back at most 2^window_log bytes, and no block is longer. 0: the default of the level.
  explicit Compressor(int level = 1, int window_log = 0);
  ~Compressor();
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;

  /// Replaces `out` with the frame. Errors (kCannotFinish): out of memory.
  Status compress(std::span<const std::byte> raw, std::vector<std::byte>& out);

 private:
  ZSTD_CCtx_s* context_;
  // For the worst that compression can do. Not cleared: pages that a frame does not reach cost nothing.
  std::unique_ptr<std::byte[]> room_;
  std::size_t room_bytes_ = 0;
};

/// The sizes of a zstd frame, as the frame states them.
struct FrameSize {
  std::size_t stored_bytes = 0;
  std::uint64_t raw_bytes = 0;
};

/// The sizes of the frame at the start of `bytes`; other bytes may follow the frame. None where no complete frame
/// begins, or the frame does not state its size.
std::optional<FrameSize> frame_at(std::span<const std::byte> bytes);

/// The message in a frame. raw_bytes: its size as the prelude states it. Errors name neither file nor offset. kDamaged:
/// the frame states another size, the size exceeds `limit`, or zstd cannot read the frame. kCannotFinish: out of
/// memory.
Result<MessageBytes> decompress(std::span<const std::byte> frame, std::uint64_t raw_bytes, std::uint64_t limit);

}  // namespace tumble::replay
