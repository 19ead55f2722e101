#include "replay/recover/salvage_frames.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "replay/format/limits.h"

namespace tumble::replay {
namespace {

constexpr std::array kZstdMagic = {std::byte{0x28}, std::byte{0xb5}, std::byte{0x2f}, std::byte{0xfd}};

/// Tries every occurrence of the magic number of zstd. A frame that decompresses with a correct checksum is taken, and
/// the search continues behind the frame; after a failure it continues behind the magic number. The total work is
/// limited, because hostile bytes may contain any number of magic numbers in front of long frames.
class FrameFinder {
 public:
  FrameFinder(const ByteSource& source, std::vector<LooseFrame>& frames)
      : source_(source), frames_(frames), work_left_(kSalvageWork * source.size() + kScrapBytesMax) {}

  void search(const Scrap& scrap) {
    if (scrap.end - scrap.begin > kScrapBytesMax) return;
    bytes_.resize(scrap.end - scrap.begin);
    if (!source_.read(scrap.begin, bytes_).ok()) return;
    auto at = bytes_.begin();
    while (true) {
      at = std::search(at, bytes_.end(), kZstdMagic.begin(), kZstdMagic.end());
      if (at == bytes_.end()) return;
      const auto place = static_cast<std::size_t>(at - bytes_.begin());
      const std::size_t length = take(scrap.begin + place, std::span(bytes_).subspan(place));
      at += static_cast<std::ptrdiff_t>(std::max(length, kZstdMagic.size()));
    }
  }

 private:
  /// The length of the frame; 0 without a frame that decompresses.
  std::size_t take(std::uint64_t offset, std::span<const std::byte> rest) {
    if (work_left_ < rest.size()) return 0;
    work_left_ -= rest.size();
    const std::optional<FrameSize> size = frame_at(rest);
    if (!size || size->raw_bytes > std::min(work_left_, message_bytes_max(offset + size->stored_bytes))) return 0;
    work_left_ -= size->raw_bytes;
    const std::span<const std::byte> stored = rest.first(size->stored_bytes);
    if (!decompress(stored, size->raw_bytes, kChunkBytesMax).ok()) return 0;
    frames_.push_back({offset, size->stored_bytes, size->raw_bytes, hash_bytes(stored)});
    return size->stored_bytes;
  }

  const ByteSource& source_;
  std::vector<LooseFrame>& frames_;
  std::vector<std::byte> bytes_;
  std::uint64_t work_left_;
};

}  // namespace

std::vector<LooseFrame> find_frames(const ByteSource& source, const std::vector<Scrap>& scraps) {
  std::vector<LooseFrame> frames;
  FrameFinder finder(source, frames);
  for (const Scrap& scrap : scraps) finder.search(scrap);
  return frames;
}

Result<MessageBytes> read_frame(const ByteSource& source, const LooseFrame& frame) {
  std::vector<std::byte> stored(frame.stored_bytes);
  if (Status ok = source.read(frame.offset, stored); !ok.ok()) return ok.error();
  return decompress(stored, frame.raw_bytes, kChunkBytesMax);
}

}  // namespace tumble::replay
