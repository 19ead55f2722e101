#include "replay/recover/salvage_pieces.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "replay/format/limits.h"
#include "replay/log/scan.h"

namespace tumble::replay {
namespace {

/// Takes each record that is found at the earliest byte, and continues behind the record. A prelude whose stored bytes
/// do not match is skipped alone, because an intact record may lie inside the bytes that a damaged prelude claims.
class PieceFinder {
 public:
  explicit PieceFinder(const ByteSource& source) : source_(source) {}

  Pieces run() {
    std::uint64_t at = 0;
    while (const std::optional<FoundPrelude> found = find_prelude(source_, at, std::nullopt)) {
      const std::uint64_t length = take(*found);
      if (length == 0) {
        at = found->offset + kPreludeBytes;
        continue;
      }
      scrap_up_to(found->offset);
      at = good_end_ = found->offset + length;
    }
    scrap_up_to(source_.size());
    return std::move(pieces_);
  }

 private:
  void scrap_up_to(std::uint64_t end) {
    if (end > good_end_) pieces_.scraps.push_back({good_end_, end});
  }

  /// The length of the record; 0 if its stored bytes do not match the prelude.
  std::uint64_t take(const FoundPrelude& found) {
    const Piece piece = {found.offset, found.prelude};
    if (found.prelude.kind == RecordKind::kFooter) return take_footer(piece);
    const std::uint64_t left = source_.size() - found.offset - kPreludeBytes;
    const std::uint64_t stored = found.prelude.stored_bytes;
    const bool may_be = found.prelude.kind != RecordKind::kGolden && stored <= left && stored <= kChunkBytesMax;
    if (!may_be || work_ > kSalvageWork * source_.size()) return 0;
    work_ += stored;
    bytes_.resize(stored);
    if (!source_.read(found.offset + kPreludeBytes, bytes_).ok()) return 0;
    if (hash_bytes(bytes_) != found.prelude.stored_hash) return 0;
    pieces_.records.push_back(piece);
    return kPreludeBytes + stored;
  }

  std::uint64_t take_footer(const Piece& piece) {
    std::array<std::byte, kFooterBytes> bytes;
    if (!source_.read(piece.offset, bytes).ok() || !decode_footer(bytes).ok()) return 0;
    pieces_.footers.push_back(piece);
    return kFooterBytes;
  }

  const ByteSource& source_;
  std::vector<std::byte> bytes_;
  std::uint64_t good_end_ = 0;  // of the record found last
  std::uint64_t work_ = 0;      // bytes hashed
  Pieces pieces_;
};

}  // namespace

Pieces find_pieces(const ByteSource& source) { return PieceFinder(source).run(); }

OtherParts parts_of_others(const Pieces& pieces, std::uint64_t tag) {
  OtherParts others;
  std::set<std::uint64_t> logs;
  for (const std::vector<Piece>* list : {&pieces.records, &pieces.footers}) {
    for (const Piece& piece : *list) {
      if (piece.prelude.log_tag == tag) continue;
      logs.insert(piece.prelude.log_tag);
      ++others.records;
      if (piece.prelude.kind == RecordKind::kChunk) others.steps += piece.prelude.step_count;
    }
  }
  others.logs = logs.size();
  return others;
}

std::string scrap_text(const ByteSource& source, const Scrap& scrap) {
  const std::uint64_t length = scrap.end - scrap.begin;
  const std::string text = std::to_string(length) + " bytes from byte " + std::to_string(scrap.begin) + " on are ";
  std::array<std::byte, kPreludeBytes> bytes = {};
  const auto start = std::span(bytes).first(std::min<std::uint64_t>(length, kPreludeBytes));
  const bool cut = length >= kMagicEnd && scrap.end == source.size() && source.read(scrap.begin, start).ok() &&
                   starts_like_log(start);
  if (!cut) return text + "part of no whole record";
  const Result<Prelude> prelude = decode_prelude(bytes);
  const bool whole =
      prelude.ok() && prelude->kind != RecordKind::kFooter && prelude->stored_bytes <= length - kPreludeBytes;
  if (whole) return text + "part of no whole record";
  return text + "the beginning of the " + name_of(prelude.ok() ? prelude->kind : RecordKind{}) +
         " that stood there; the file lacks the rest of it";
}

}  // namespace tumble::replay
