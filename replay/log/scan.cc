#include "replay/log/scan.h"

#include <algorithm>
#include <span>
#include <utility>

#include "replay/format/limits.h"
#include "replay/log/record_reader.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

constexpr std::size_t kWindowMin = 4096;  // bytes per read of a search; doubles, so that short searches stay cheap
constexpr std::size_t kWindowMax = 1 << 20;

std::string at_byte(std::uint64_t offset) { return "at byte " + std::to_string(offset); }

/// Follows the records of a log from the end of its header.
///
/// A record is found by the length that the prelude before it states. Where a prelude is damaged that length is lost,
/// so the walk searches for the next prelude byte by byte: the 12 fixed bytes rarely occur by chance, and the hash
/// inside a prelude and the tag of the log exclude the rest. LevelDB's log reader resynchronises at block boundaries
/// instead (db/log_reader.cc); records of this format have any length, so there are no boundaries to rely on.
class Walk {
 public:
  Walk(const ByteSource& source, const Prelude& header, const std::vector<MissingSteps>& missing)
      : source_(source), records_(source), header_(header), missing_(missing) {
    offset_ = kPreludeBytes + header.stored_bytes;
    chain_ = header.chain_after;
    result_.condition.torn_offset = offset_;
  }

  Scan run() {
    const std::string writer = source_.writer();  // before the end is read: it may come meanwhile
    while (offset_ < source_.size() && read_record()) {
    }
    LogCondition& condition = result_.condition;
    condition.finished = result_.footer.has_value();
    condition.torn = torn_ || (!condition.finished && offset_ >= source_.size());
    if (condition.torn) condition.writer = writer;
    condition.missing = missing_;
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::uint64_t left() const { return source_.size() - offset_; }

  void add_damage(RecordKind kind, std::uint64_t offset, std::string message) {
    result_.condition.damages.push_back({kind, offset, std::move(message)});
  }

  /// Returns false where the walk ends.
  bool read_record() {
    if (result_.footer) return stray_bytes();
    if (left() < kPreludeBytes) return incomplete_prelude();
    const auto bytes = records_.read_bytes<kPreludeBytes>(offset_);
    if (!bytes.ok()) return unreadable(bytes.error().message);
    const Result<Prelude> prelude = decode_prelude(*bytes);
    if (!prelude.ok()) return zeros_to_end() ? torn() : skip_to_next(prelude.error().message);
    if (prelude->log_tag != header_.log_tag || prelude->kind == RecordKind::kHeader) {
      return skip_to_next("found a record of another log");
    }
    if (prelude->kind == RecordKind::kFooter) return read_footer();
    if (prelude->stored_bytes > left() - kPreludeBytes) return torn();
    take(*prelude);
    return true;
  }

  bool torn() {
    torn_ = true;
    return false;
  }

  bool unreadable(const std::string& why) {
    add_damage(RecordKind::kChunk, offset_, why);
    return false;
  }

  bool stray_bytes() {
    add_damage(RecordKind::kFooter, offset_,
               "found " + std::to_string(left()) + " bytes after the footer " + at_byte(offset_) + ", wanted none");
    return false;
  }

  bool incomplete_prelude() {
    std::vector<std::byte> bytes(left());
    if (Status ok = source_.read(offset_, bytes); !ok.ok()) return unreadable(ok.error().message);
    if (starts_like_log(bytes) || zeros_to_end()) return torn();
    add_damage(RecordKind::kChunk, offset_,
               "found " + std::to_string(left()) + " bytes " + at_byte(offset_) + " that begin no record");
    return false;
  }

  /// A system that loses power may keep the length of a write without its bytes.
  bool zeros_to_end() {
    std::vector<std::byte> bytes;
    std::size_t window = kWindowMin;
    for (std::uint64_t at = offset_; at < source_.size(); at += bytes.size()) {
      bytes.resize(std::min<std::uint64_t>(window, source_.size() - at));
      window = std::min(2 * window, kWindowMax);
      if (!source_.read(at, bytes).ok()) return false;
      if (std::any_of(bytes.begin(), bytes.end(), [](std::byte b) { return b != std::byte{0}; })) return false;
    }
    return true;
  }

  /// Reports damage at the current place and moves to the next prelude of this log. Returns false without one.
  bool skip_to_next(const std::string& why) {
    const std::uint64_t hurt = offset_;
    const std::optional<FoundPrelude> next = find_prelude(source_, offset_ + 1, header_.log_tag);
    const std::string then = next ? "the next record begins " + at_byte(next->offset) : "no record follows";
    RecordKind kind = result_.index ? RecordKind::kFooter : RecordKind::kChunk;
    if (next && next->prelude.kind == RecordKind::kFooter && !result_.index) kind = RecordKind::kIndex;
    add_damage(kind, hurt, std::string(name_of(kind)) + " " + at_byte(hurt) + ": " + why + "; " + then);
    if (!next) return false;
    offset_ = next->offset;
    after_loss_ = true;
    return true;
  }

  void take(const Prelude& prelude) {
    const ChunkPlace place = place_of(prelude, offset_);
    const bool in_order = check_order(prelude);
    if (prelude.kind == RecordKind::kIndex) {
      result_.index = place;
    } else if (in_order) {
      result_.chunks.push_back(place);
    }
    sequence_ = prelude.sequence + 1;
    chain_ = prelude.chain_after;
    offset_ += place.length;
    result_.condition.torn_offset = offset_;
    after_loss_ = false;
  }

  /// A record that was removed, inserted or moved shows in the sequence numbers and in the chain. Behind damage,
  /// missing records are expected. Returns false for a chunk that does not follow the chunks before.
  bool check_order(const Prelude& prelude) {
    const std::string record = std::string(name_of(prelude.kind)) + " " + at_byte(offset_) + ": found ";
    const std::uint64_t end = result_.chunks.empty() ? header_.first_step + 1 : result_.chunks.back().end_step();
    const std::uint64_t wanted = step_after(end, missing_);
    const bool after_missing = prelude.kind == RecordKind::kChunk && wanted != end;
    if (prelude.kind == RecordKind::kChunk && (prelude.first_step < wanted || prelude.first_step > sim::kStepsMax ||
                                               prelude.step_count > kStepsPerChunkRead)) {
      add_damage(prelude.kind, offset_,
                 record + "first step " + std::to_string(prelude.first_step) + " and " +
                     std::to_string(prelude.step_count) + " steps, wanted step " + std::to_string(wanted) +
                     " or later");
      return false;
    }
    if (after_loss_ && prelude.sequence > sequence_) return true;
    if (prelude.sequence != sequence_) {
      add_damage(
          prelude.kind, offset_,
          record + "record number " + std::to_string(prelude.sequence) + ", wanted " + std::to_string(sequence_));
    } else if (prelude.kind == RecordKind::kChunk && prelude.first_step != wanted) {
      add_damage(prelude.kind, offset_,
                 record + "first step " + std::to_string(prelude.first_step) + ", wanted " + std::to_string(wanted));
    } else if (!after_missing && prelude.chain_before != chain_) {
      add_damage(prelude.kind, offset_,
                 record + "chain " + to_string(prelude.chain_before) + " before it, wanted " + to_string(chain_));
    }
    return true;
  }

  bool read_footer() {
    if (left() < kFooterBytes) return torn();
    const auto bytes = records_.read_bytes<kFooterBytes>(offset_);
    if (!bytes.ok()) return unreadable(bytes.error().message);
    const Result<Footer> footer = decode_footer(*bytes);
    if (!footer.ok()) return skip_to_next(footer.error().message);
    check_order(footer->prelude);
    result_.footer = *footer;
    result_.footer_offset = offset_;
    offset_ += kFooterBytes;
    return true;
  }

  const ByteSource& source_;
  const RecordReader records_;
  const Prelude& header_;
  const std::vector<MissingSteps>& missing_;
  std::uint64_t offset_;
  std::uint64_t sequence_ = 1;
  Hash128 chain_;
  bool after_loss_ = false;  // the record before was lost
  bool torn_ = false;        // the file ends inside a record
  Scan result_;
};

}  // namespace

Scan scan_records(const ByteSource& source, const Prelude& header, const std::vector<MissingSteps>& missing) {
  return Walk(source, header, missing).run();
}

std::optional<FoundPrelude> find_prelude(const ByteSource& source, std::uint64_t from,
                                         std::optional<std::uint64_t> log_tag) {
  std::vector<std::byte> bytes;
  std::size_t window = kWindowMin;
  while (from + kPreludeBytes <= source.size()) {
    bytes.resize(std::min<std::uint64_t>(window, source.size() - from));
    if (!source.read(from, bytes).ok()) return std::nullopt;
    const std::size_t places = bytes.size() - kPreludeBytes + 1;
    for (std::size_t i = 0; i < places; ++i) {
      const auto candidate = std::span<const std::byte>(bytes).subspan(i).first<kPreludeBytes>();
      if (candidate[8] != std::byte{0x89} || !starts_like_log(candidate)) continue;
      const Result<Prelude> prelude = decode_prelude(candidate);
      if (prelude.ok() && prelude->log_tag == log_tag.value_or(prelude->log_tag)) {
        return FoundPrelude{from + i, *prelude};
      }
    }
    from += places;
    window = std::min(2 * window, kWindowMax);
  }
  return std::nullopt;
}

}  // namespace tumble::replay
