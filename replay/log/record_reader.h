#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "replay/codec/chunk_codec.h"
#include "replay/format/chunk.h"
#include "replay/format/prelude.h"
#include "replay/format/step_record.h"
#include "replay/log/byte_io.h"
#include "src/base/result.h"

namespace tumble::replay {

/// The first record of a log.
struct HeaderRecord {
  Prelude prelude;
  LogHeader content;
};

/// What every chunk of a log must agree with. The log's header says it.
struct ChunkRules {
  std::uint64_t log_tag = 0;
  std::size_t phase_count = 0;  ///< phase words come in rows of so many; 0: any number
};

/// Reads single records and checks each against its prelude: the mirror of RecordWriter. The order of the records is
/// checked by LogReader (with the index) and scan_records() (without).
///
/// Errors name path, record and byte. kDamaged: bytes that nobody wrote so. kBadInput: a file that is no log, a record
/// that needs a newer program. kCannotFinish: a read that fails, memory.
class RecordReader {
 public:
  /// `source` must outlive the reader.
  explicit RecordReader(const ByteSource& source) : source_(source) {}

  /// The header record, at byte 0. The format version and the chain of LogHeader::goes_on are filled in.
  [[nodiscard]] Result<HeaderRecord> read_header() const;

  /// The chunk at a place: its stored hash, its counts and the chain over its steps are checked.
  [[nodiscard]] Result<ChunkDecoder> read_chunk(const ChunkPlace& place, const ChunkRules& rules) const;

  /// The rows of the index record at a byte of the log with this tag. The rows themselves are not checked.
  [[nodiscard]] Result<std::vector<ChunkPlace>> read_index(std::uint64_t offset, std::uint64_t log_tag) const;

  /// The prelude at a byte.
  [[nodiscard]] Result<Prelude> read_prelude(std::uint64_t offset) const;

  /// The message behind a prelude, compared with its stored hash and decompressed.
  [[nodiscard]] Result<MessageBytes> read_payload(std::uint64_t offset, const Prelude& prelude) const;

  /// So many bytes, unchecked: of a prelude or a footer.
  template <std::size_t kCount>
  [[nodiscard]] Result<std::array<std::byte, kCount>> read_bytes(std::uint64_t offset) const {
    std::array<std::byte, kCount> bytes;
    if (Status ok = source_.read(offset, bytes); !ok.ok()) return ok.error();
    return bytes;
  }

 private:
  [[nodiscard]] Result<Prelude> read_header_prelude() const;

  const ByteSource& source_;
};

/// Where a record with this prelude lies if its prelude begins at `offset`.
ChunkPlace place_of(const Prelude& prelude, std::uint64_t offset);

/// "<path>: <record> at byte <offset>: <message>".
Error error_at(const ByteSource& source, const std::string& record, std::uint64_t offset, const Error& error);

}  // namespace tumble::replay
