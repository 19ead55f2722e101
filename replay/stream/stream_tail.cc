#include "replay/stream/stream_tail.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <utility>

#include "replay/format/little_endian.h"
#include "replay/stream/stream_format.h"

namespace tumble::replay {
namespace {

using Bytes = std::vector<std::byte>;

struct Frame {
  std::uint32_t kind = 0;
  std::uint64_t size = 0;  // of its payload
  std::uint64_t number = 0;
  std::uint64_t hash = 0;
};

Frame frame_of(std::span<const std::byte> head) {
  return {load<std::uint32_t>(head.data()), load<std::uint32_t>(head.data() + 4), load<std::uint64_t>(head.data() + 8),
          load<std::uint64_t>(head.data() + 16)};
}

/// How far a stream's file goes.
struct Extent {
  std::uint64_t bytes = kStreamPreludeBytes;  // up to the end of its last whole frame
  std::uint64_t next = 0;                     // the number that the next frame would have
  std::uint64_t tag = 0;
  bool finished = false;
  std::optional<std::uint64_t> asked_hash;  // of the frame with the number asked for
};

/// Takes the frames by their lengths: whoever reads the stream checks their hashes.
Result<Extent> extent_of(const ByteSource& stream, std::uint64_t asked) {
  Extent extent;
  std::array<std::byte, kStreamFrameHeadBytes> head{};
  while (stream.size() >= extent.bytes + head.size()) {
    if (Status ok = stream.read(extent.bytes, head); !ok.ok()) return ok.error();
    const Frame frame = frame_of(head);
    if (frame.kind == 0 || frame.size > stream.size() - extent.bytes - head.size()) break;
    if (extent.next == 0) extent.tag = frame.hash;
    if (frame.number == asked) extent.asked_hash = frame.hash;
    extent.finished = extent.finished || frame.kind == static_cast<std::uint32_t>(StreamFrameKind::kEnd);
    extent.next = frame.number + 1;
    extent.bytes += head.size() + frame.size;
  }
  return extent;
}

/// The frames of a tail from number `next` on: one behind the other, up to the first that is none of this stream, as
/// remains of an earlier use of the tail are.
Bytes new_frames(std::span<const std::byte> tail, std::uint64_t tag, std::uint64_t next) {
  Bytes frames;
  std::size_t at = kStreamTailHeadBytes;
  while (tail.size() - at >= kStreamFrameHeadBytes) {
    const auto head = tail.subspan(at, kStreamFrameHeadBytes);
    const Frame frame = frame_of(head);
    if (frame.size > tail.size() - at - head.size()) break;
    const auto payload = tail.subspan(at + head.size(), frame.size);
    if (XXH64(payload.data(), payload.size(), XXH64(head.data(), 16, tag)) != frame.hash) break;
    if (frame.number > next) break;
    const std::size_t size = head.size() + payload.size();
    if (frame.number == next) {
      const auto whole = tail.subspan(at, size);
      frames.insert(frames.end(), whole.begin(), whole.end());
      ++next;
    }
    at += size;
  }
  return frames;
}

/// The first bytes of a file, then others.
class JoinedSource : public ByteSource {
 public:
  JoinedSource(std::unique_ptr<ByteSource> first, std::uint64_t first_bytes, Bytes rest)
      : first_(std::move(first)), first_bytes_(first_bytes), rest_(std::move(rest)) {}

  [[nodiscard]] std::uint64_t size() const override { return first_bytes_ + rest_.size(); }
  [[nodiscard]] std::string name() const override { return first_->name(); }

  Status read(std::uint64_t offset, std::span<std::byte> bytes) const override {
    if (offset > size() || bytes.size() > size() - offset) return damaged(name() + ": ends too early");
    const std::uint64_t in_first =
        offset < first_bytes_ ? std::min<std::uint64_t>(bytes.size(), first_bytes_ - offset) : 0;
    if (in_first > 0) {
      if (Status ok = first_->read(offset, bytes.first(in_first)); !ok.ok()) return ok;
    }
    const std::size_t left = bytes.size() - in_first;
    if (left > 0) std::memcpy(bytes.data() + in_first, rest_.data() + (offset + in_first - first_bytes_), left);
    return {};
  }

 private:
  std::unique_ptr<ByteSource> first_;
  std::uint64_t first_bytes_;
  Bytes rest_;
};

bool is_tail(const Bytes& tail) {
  return tail.size() >= kStreamTailHeadBytes &&
         std::memcmp(tail.data(), kStreamTailMagic.data(), kStreamTailMagic.size()) == 0;
}

/// With the hash of the frame that the tail names as the one before it.
Result<Extent> extent_before(const ByteSource& stream, const Bytes& tail) {
  return extent_of(stream, load<std::uint64_t>(tail.data() + 24));
}

bool follows(const Extent& extent, const Bytes& tail) {
  return extent.next > 0 && extent.tag == load<std::uint64_t>(tail.data() + 16) &&
         extent.asked_hash == load<std::uint64_t>(tail.data() + 32);
}

Bytes read_tail(const std::string& path) {
  Bytes tail;
  if (Result<std::unique_ptr<ByteSource>> file = open_file_source(path + kStreamTailSuffix); file.ok()) {
    tail.resize(std::min<std::uint64_t>((*file)->size(), kStreamTailBytesMax));
    if (!(*file)->read(0, tail).ok()) tail.clear();
  }
  return tail;
}

}  // namespace

Result<std::unique_ptr<ByteSource>> with_tail(std::unique_ptr<ByteSource> stream, const Bytes& tail) {
  if (!is_tail(tail) || stream->size() < kStreamPreludeBytes) return stream;
  const Result<Extent> extent = extent_before(*stream, tail);
  if (!extent.ok()) return extent.error();
  if (extent->finished || !follows(*extent, tail)) return stream;
  Bytes frames = new_frames(tail, extent->tag, extent->next);
  if (frames.empty()) return stream;
  return std::unique_ptr<ByteSource>(
      std::make_unique<JoinedSource>(std::move(stream), extent->bytes, std::move(frames)));
}

bool has_own_tail(const std::string& path) {
  const Bytes tail = read_tail(path);
  const Result<std::unique_ptr<ByteSource>> stream = open_file_source(path);
  if (!is_tail(tail) || !stream.ok() || (*stream)->size() < kStreamPreludeBytes) return false;
  const Result<Extent> extent = extent_before(**stream, tail);
  return extent.ok() && follows(*extent, tail);
}

// The tail is read first: frames that a recorder at work moves to the file meanwhile are then found there.
Result<std::unique_ptr<ByteSource>> open_stream_source(const std::string& path) {
  const Bytes tail = read_tail(path);
  Result<std::unique_ptr<ByteSource>> stream = open_file_source(path);
  if (!stream.ok()) return stream.error();
  return with_tail(*std::move(stream), tail);
}

}  // namespace tumble::replay
