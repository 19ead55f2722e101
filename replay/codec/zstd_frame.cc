#include "replay/codec/zstd_frame.h"

#include <zstd.h>

#include <new>
#include <string>

#include "replay/format/limits.h"

namespace tumble::replay {
namespace {

struct FreeDecompressor {
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

std::string number(std::uint64_t value) { return std::to_string(value); }

}  // namespace

Compressor::Compressor(int level, int window_log) : context_(ZSTD_createCCtx()) {
  if (context_ == nullptr) return;
  ZSTD_CCtx_setParameter(context_, ZSTD_c_compressionLevel, level);
  ZSTD_CCtx_setParameter(context_, ZSTD_c_windowLog, window_log);
  ZSTD_CCtx_setParameter(context_, ZSTD_c_contentSizeFlag, 1);
  ZSTD_CCtx_setParameter(context_, ZSTD_c_checksumFlag, 1);  // off by default; without it flipped bits go unnoticed
}

Compressor::~Compressor() { ZSTD_freeCCtx(context_); }

Status Compressor::compress(std::span<const std::byte> raw, std::vector<std::byte>& out) {
  if (context_ == nullptr) return cannot_finish("out of memory for compression");
  const std::size_t bound = ZSTD_compressBound(raw.size());
  if (bound > room_bytes_) {
    room_.reset();
    room_ = std::make_unique_for_overwrite<std::byte[]>(bound);
    room_bytes_ = bound;
  }
  const std::size_t size = ZSTD_compress2(context_, room_.get(), bound, raw.data(), raw.size());
  if (ZSTD_isError(size) != 0) return cannot_finish(std::string("compression failed: ") + ZSTD_getErrorName(size));
  out.assign(room_.get(), room_.get() + size);
  const std::optional<FrameSize> frame = frame_at(out);
  SIM_CHECK(frame && frame->stored_bytes == size && frame->raw_bytes == raw.size(), size, raw.size());
  return {};
}

std::optional<FrameSize> frame_at(std::span<const std::byte> bytes) {
  const unsigned long long raw = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (raw == ZSTD_CONTENTSIZE_ERROR || raw == ZSTD_CONTENTSIZE_UNKNOWN) return std::nullopt;
  const std::size_t stored = ZSTD_findFrameCompressedSize(bytes.data(), bytes.size());
  if (ZSTD_isError(stored) != 0) return std::nullopt;
  return FrameSize{stored, raw};
}

// Memory is allocated for the size that the prelude states, so three things are compared first: the limit for this
// record, the best possible ratio of zstd, and the size inside the frame. Only then does a wrong size cost no more than
// a read.
Result<MessageBytes> decompress(std::span<const std::byte> frame, std::uint64_t raw_bytes, std::uint64_t limit) {
  if (raw_bytes > limit || raw_bytes % 8 != 0 || raw_bytes > (frame.size() + 64) * kZstdExpansionMax) {
    return damaged("found a message of " + number(raw_bytes) + " bytes in " + number(frame.size()) +
                   ", wanted a multiple of 8 up to " + number(limit) + " that can come from so few");
  }
  if (ZSTD_getFrameContentSize(frame.data(), frame.size()) != raw_bytes ||
      ZSTD_findFrameCompressedSize(frame.data(), frame.size()) != frame.size()) {
    return damaged("found something else than one zstd frame of " + number(raw_bytes) + " bytes, as the record says");
  }
  const std::unique_ptr<ZSTD_DCtx, FreeDecompressor> context(ZSTD_createDCtx());
  if (context == nullptr) return cannot_finish("out of memory for decompression");
  MessageBytes message(raw_bytes);
  const std::size_t size =
      ZSTD_decompressDCtx(context.get(), message.bytes().data(), raw_bytes, frame.data(), frame.size());
  if (ZSTD_isError(size) != 0) return damaged(std::string("zstd cannot read the frame: ") + ZSTD_getErrorName(size));
  if (size != raw_bytes) return damaged("found " + number(size) + " bytes in the frame, wanted " + number(raw_bytes));
  return message;
}

}  // namespace tumble::replay
