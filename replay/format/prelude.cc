#include "tumble/replay/prelude.h"

#include <algorithm>

#include "replay/format/limits.h"
#include "replay/format/little_endian.h"

namespace tumble::replay {
namespace {

constexpr std::uint32_t kSkippableMagic = 0x184D2A54;
constexpr std::array<unsigned char, 8> kMagic = {0x89, 't', 'u', 'm', 'b', 'l', 'e', '\n'};
constexpr std::size_t kHashedPart = 120;        // of a prelude
constexpr std::size_t kHashedFooterPart = 176;  // of a footer

void store_hash(std::byte* at, const Hash128& hash) {
  store(at, hash.low);
  store(at + 8, hash.high);
}

Hash128 load_hash(const std::byte* at) { return {load<std::uint64_t>(at + 8), load<std::uint64_t>(at)}; }

std::uint32_t frame_bytes(RecordKind kind) { return (kind == RecordKind::kFooter ? kFooterBytes : kPreludeBytes) - 8; }

/// The fixed bytes among the first kMagicEnd: all but the length of the frame, which the hash of the prelude covers.
constexpr std::size_t kMagicBytes = 12;

struct MagicMatch {
  std::size_t compared = 0;
  std::size_t equal = 0;
};

MagicMatch match_magic(std::span<const std::byte> start) {
  std::array<std::byte, kMagicEnd> wanted = {};
  store(wanted.data(), kSkippableMagic);
  std::memcpy(wanted.data() + 8, kMagic.data(), kMagic.size());
  MagicMatch match;
  for (std::size_t i = 0; i < std::min(start.size(), kMagicEnd); ++i) {
    if (i >= 4 && i < 8) continue;
    ++match.compared;
    if (start[i] == wanted[i]) ++match.equal;
  }
  return match;
}

std::string hex(std::uint64_t value) { return to_string(Hash128{0, value}).substr(16); }

void encode_prelude(const Prelude& prelude, std::byte* at) {
  store(at, kSkippableMagic);
  store(at + 4, frame_bytes(prelude.kind));
  std::memcpy(at + 8, kMagic.data(), kMagic.size());
  store(at + 16, prelude.major);
  store(at + 18, prelude.minor);
  store(at + 20, static_cast<std::uint16_t>(prelude.kind));
  store(at + 22, std::uint16_t{0});
  store(at + 24, prelude.sequence);
  store(at + 32, prelude.first_step);
  store(at + 40, prelude.step_count);
  store(at + 48, prelude.stored_bytes);
  store(at + 56, prelude.raw_bytes);
  store_hash(at + 64, prelude.stored_hash);
  store_hash(at + 80, prelude.chain_before);
  store_hash(at + 96, prelude.chain_after);
  store(at + 112, prelude.log_tag);
  store(at + kHashedPart, hash_bytes({at, kHashedPart}).low);
}

Prelude fields_of(const std::byte* at) {
  Prelude prelude;
  prelude.major = load<std::uint16_t>(at + 16);
  prelude.minor = load<std::uint16_t>(at + 18);
  prelude.kind = static_cast<RecordKind>(load<std::uint16_t>(at + 20));
  prelude.sequence = load<std::uint64_t>(at + 24);
  prelude.first_step = load<std::uint64_t>(at + 32);
  prelude.step_count = load<std::uint64_t>(at + 40);
  prelude.stored_bytes = load<std::uint64_t>(at + 48);
  prelude.raw_bytes = load<std::uint64_t>(at + 56);
  prelude.stored_hash = load_hash(at + 64);
  prelude.chain_before = load_hash(at + 80);
  prelude.chain_after = load_hash(at + 96);
  prelude.log_tag = load<std::uint64_t>(at + 112);
  return prelude;
}

/// Whether only the major version of a prelude was damaged. With this format's version put back, the hash of such a
/// prelude matches. A prelude of a newer version has the newer number in its own hash, or another layout, and never
/// matches. Without this test a flipped bit in the version would be reported as "needs a newer program".
bool version_is_damaged(std::span<const std::byte, kPreludeBytes> bytes) {
  std::array<std::byte, kPreludeBytes> ours;
  std::copy(bytes.begin(), bytes.end(), ours.begin());
  for (std::uint16_t major = kFormatMajor; major <= kExtrasMajor; ++major) {
    store(ours.data() + 16, major);
    if (hash_bytes({ours.data(), kHashedPart}).low == load<std::uint64_t>(ours.data() + kHashedPart)) return true;
  }
  return false;
}

}  // namespace

const char* name_of(RecordKind kind) {
  switch (kind) {
    case RecordKind::kHeader:
      return "header";
    case RecordKind::kChunk:
      return "chunk";
    case RecordKind::kIndex:
      return "index";
    case RecordKind::kFooter:
      return "footer";
    case RecordKind::kGolden:
      return "golden";
  }
  return "record";
}

void Prelude::set_extras() {
  major = kExtrasMajor;
  minor = kExtrasMinor;
}

std::array<std::byte, kPreludeBytes> encode(const Prelude& prelude) {
  std::array<std::byte, kPreludeBytes> bytes;
  encode_prelude(prelude, bytes.data());
  return bytes;
}

std::array<std::byte, kFooterBytes> encode(const Footer& footer) {
  std::array<std::byte, kFooterBytes> bytes = {};
  encode_prelude(footer.prelude, bytes.data());
  store(bytes.data() + 128, footer.index_offset);
  store(bytes.data() + 136, footer.file_bytes);
  store_hash(bytes.data() + 144, footer.final_state_hash);
  store_hash(bytes.data() + kHashedFooterPart, hash_bytes({bytes.data(), kHashedFooterPart}));
  return bytes;
}

bool starts_like_log(std::span<const std::byte> start) {
  const MagicMatch match = match_magic(start);
  return match.compared > 0 && match.equal == match.compared;
}

bool nearly_starts_like_log(std::span<const std::byte> start) {
  const MagicMatch match = match_magic(start);
  return match.compared == kMagicBytes && match.equal >= kMagicBytes / 2;
}

Result<Prelude> decode_prelude(std::span<const std::byte, kPreludeBytes> bytes) {
  if (!starts_like_log(bytes)) return damaged("found no record: the bytes are not those that every record starts with");
  const Prelude prelude = fields_of(bytes.data());
  if (prelude.major > kExtrasMajor && !version_is_damaged(bytes)) {
    return bad_input("found format version " + std::to_string(prelude.major) + "." + std::to_string(prelude.minor) +
                     ", this program reads versions up to " + std::to_string(kExtrasMajor) +
                     ".x; use a program that writes or reads version " + std::to_string(prelude.major));
  }
  const std::uint64_t wanted = hash_bytes(bytes.first<kHashedPart>()).low;
  const auto found = load<std::uint64_t>(bytes.data() + kHashedPart);
  if (found != wanted) {
    return damaged("the record's first 120 bytes are not what was written: found hash " + hex(wanted) + ", wanted " +
                   hex(found));
  }
  if (load<std::uint32_t>(bytes.data() + 4) != frame_bytes(prelude.kind) ||
      load<std::uint16_t>(bytes.data() + 22) != 0 || std::string_view(name_of(prelude.kind)) == "record") {
    return damaged("the record's kind " + std::to_string(static_cast<unsigned>(prelude.kind)) +
                   " is not one of version 1");
  }
  return prelude;
}

Result<Footer> decode_footer(std::span<const std::byte, kFooterBytes> bytes) {
  Result<Prelude> prelude = decode_prelude(bytes.first<kPreludeBytes>());
  if (!prelude.ok()) return prelude.error();
  const Hash128 wanted = hash_bytes(bytes.first<kHashedFooterPart>());
  const Hash128 found = load_hash(bytes.data() + kHashedFooterPart);
  if (found != wanted) {
    return damaged("the footer is not what was written: found hash " + to_string(wanted) + ", wanted " +
                   to_string(found));
  }
  if (prelude->kind != RecordKind::kFooter) return damaged("found a " + std::string(name_of(prelude->kind)));
  return Footer{*prelude, load<std::uint64_t>(bytes.data() + 128), load<std::uint64_t>(bytes.data() + 136),
                load_hash(bytes.data() + 144)};
}

std::uint64_t raw_bytes_max(const Prelude& prelude, std::uint64_t offset) {
  if (prelude.kind == RecordKind::kHeader) return header_bytes_max(prelude.stored_bytes);
  return message_bytes_max(offset + kPreludeBytes + prelude.stored_bytes);
}

}  // namespace tumble::replay
