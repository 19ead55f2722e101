#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "replay/codec/chunk_codec.h"
#include "tumble/replay/body_table.h"
#include "tumble/replay/byte_io.h"
#include "tumble/replay/chunk.h"
#include "tumble/replay/prelude.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// The first record of a log.
struct HeaderRecord {
  Prelude prelude;
  LogHeader content;
};

/// The values of a log's header that each of its chunks must match.
struct ChunkRules {
  std::uint64_t log_tag = 0;
  std::size_t phase_count = 0;  ///< each row of phase words has this length; 0: any length
  HashesMode hashes = {};       ///< the steps that may have phase words
  /// The channels that a chunk may have values of; null: any.
  const std::vector<Channel>* channels = nullptr;
};
/// Of the log with this header, which must outlive the result.
ChunkRules rules_of(const Prelude& prelude, const LogHeader& header);

/// Reads single records and checks each against its prelude: the inverse of RecordWriter. LogReader and scan_records()
/// check the order of the records, by the index and by the preludes.
///
/// Errors name path, record and byte. kDamaged: the bytes changed after they were written. kBadInput: the file is no
/// log, or a record needs a newer program. kCannotFinish: the system cannot read, or memory runs out.
class RecordReader {
 public:
  /// `source` must outlive the reader.
  explicit RecordReader(const ByteSource& source) : source_(source) {}

  /// The header record, at byte 0. Fills in the format version and the chain of LogHeader::goes_on.
  [[nodiscard]] Result<HeaderRecord> read_header() const;

  /// The chunk at a place. Checks the stored hash, the counts and the chain over the steps.
  [[nodiscard]] Result<ChunkDecoder> read_chunk(const ChunkPlace& place, const ChunkRules& rules) const;

  /// Adds the names and shapes that the steps of a chunk tell of; nothing where the chunk cannot be read.
  void add_bodies(const ChunkPlace& place, const ChunkRules& rules, BodyTable& bodies) const;

  /// The rows of the index record at byte `offset`. Checks the record, but not whether the rows match the file.
  [[nodiscard]] Result<std::vector<ChunkPlace>> read_index(std::uint64_t offset, std::uint64_t log_tag) const;

  /// The prelude at byte `offset`.
  [[nodiscard]] Result<Prelude> read_prelude(std::uint64_t offset) const;

  /// The message behind the prelude at byte `offset`. Checks the stored hash and decompresses.
  [[nodiscard]] Result<MessageBytes> read_payload(std::uint64_t offset, const Prelude& prelude) const;

  /// The kCount bytes at `offset`, unchecked: a prelude or a footer.
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

/// The place of a record whose prelude lies at `offset`.
ChunkPlace place_of(const Prelude& prelude, std::uint64_t offset);

/// "<path>: <record> at byte <offset>: <message>".
Error error_at(const ByteSource& source, const std::string& record, std::uint64_t offset, const Error& error);

}  // namespace tumble::replay
