#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"

/// The prelude (the fixed bytes before the payload of each record) and the footer. docs/log_format.md has the same
/// tables.
namespace tumble::replay {

inline constexpr std::uint16_t kFormatMajor = 1;  ///< readers of an older major version cannot read the record
inline constexpr std::uint16_t kFormatMinor = 3;  ///< grows with every added field; older readers ignore the field
/// Of records with declarations or extras, which older readers must not pass over. A record has the lowest version that
/// holds its content, so a log without extras can be read by older programs.
inline constexpr std::uint16_t kExtrasMajor = 2;
inline constexpr std::uint16_t kExtrasMinor = 0;

enum class RecordKind : std::uint16_t { kHeader = 1, kChunk = 2, kIndex = 3, kFooter = 4, kGolden = 5 };
/// "header", "chunk", …; "record" for a value that is none of them.
const char* name_of(RecordKind kind);

/// The fixed bytes of a record before its payload.
///
/// | bytes   | meaning (little-endian)                                                                         |
/// |---------|-------------------------------------------------------------------------------------------------|
/// | 0–3     | 0x184D2A54: the start of a zstd skippable frame, so that zstd's own tools read the file         |
/// | 4–7     | 120 (footer: 184): bytes of the skippable frame that follow                                     |
/// | 8–15    | 89 't' 'u' 'm' 'b' 'l' 'e' 0A                                                                    |
/// | 16–19   | format version: major, minor (2 bytes each). Bytes 0–19 stay as they are in every version        |
/// | 20–23   | kind (2), reserved (2): 0                                                                       |
/// | 24–31   | sequence number: 0 the header, then one more a record                                           |
/// | 32–47   | first step, step count; footer and index: those of the log; header: number of the first state, 0 |
/// | 48–63   | stored bytes that follow, bytes that they decompress to                                         |
/// | 64–79   | XXH3-128 of the stored bytes: low, high                                                         |
/// | 80–111  | chain before the first and after the last step: low, high each; header: the chain's start, twice |
/// | 112–119 | low half of the header's stored hash: binds the records of one log                              |
/// | 120–127 | XXH3-128 of bytes 0–119, low half                                                                |
struct Prelude {
  std::uint16_t major = kFormatMajor;
  std::uint16_t minor = kFormatMinor;
  RecordKind kind = RecordKind::kHeader;
  std::uint64_t sequence = 0;
  std::uint64_t first_step = 0;
  std::uint64_t step_count = 0;
  std::uint64_t stored_bytes = 0;
  std::uint64_t raw_bytes = 0;
  Hash128 stored_hash;
  Hash128 chain_before;
  Hash128 chain_after;
  std::uint64_t log_tag = 0;
  void set_extras();  ///< raises the version to that of extras
  friend bool operator==(const Prelude&, const Prelude&) = default;
};

inline constexpr std::size_t kPreludeBytes = 128;
inline constexpr std::size_t kMagicEnd = 16;  ///< the bytes before this offset show that a file is a log

/// The end of a finished log: a prelude of kind footer without payload, then the bytes below, in one write.
///
/// | bytes   | meaning                                               |
/// |---------|-------------------------------------------------------|
/// | 128–135 | offset of the index record                            |
/// | 136–143 | size of the file, this footer included                |
/// | 144–159 | state hash of the last step: low, high                |
/// | 160–175 | reserved: 0                                           |
/// | 176–191 | XXH3-128 of bytes 0–175: low, high                    |
struct Footer {
  Prelude prelude;
  std::uint64_t index_offset = 0;
  std::uint64_t file_bytes = 0;
  Hash128 final_state_hash;
};

inline constexpr std::size_t kFooterBytes = 192;

std::array<std::byte, kPreludeBytes> encode(const Prelude& prelude);
std::array<std::byte, kFooterBytes> encode(const Footer& footer);

/// Whether a file with these first bytes may be a log. Compares at most kMagicEnd bytes, and fewer where `start` ends.
bool starts_like_log(std::span<const std::byte> start);

/// Whether most of the first bytes are those of a log: a damaged log rather than another file.
bool nearly_starts_like_log(std::span<const std::byte> start);

/// Reads and checks a prelude or a footer. Errors name neither file nor offset; the caller adds both. kBadInput: a
/// newer major version; the message names the program that is needed. kDamaged: everything else.
Result<Prelude> decode_prelude(std::span<const std::byte, kPreludeBytes> bytes);
Result<Footer> decode_footer(std::span<const std::byte, kFooterBytes> bytes);

/// The most bytes that the message of the record at byte `offset` may decompress to (limits.h).
std::uint64_t raw_bytes_max(const Prelude& prelude, std::uint64_t offset);

}  // namespace tumble::replay
