#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "replay/codec/index_codec.h"
#include "replay/format/prelude.h"
#include "replay/format/step_record.h"
#include "replay/log/byte_io.h"

namespace tumble::replay {

/// Something in a log that is not as it was written.
struct Damage {
  RecordKind kind = RecordKind::kChunk;  ///< of the record that is hurt
  std::uint64_t offset = 0;              ///< its first byte, or the first byte that belongs to no record
  std::string message;                   ///< record, byte, found, wanted
};

/// How whole a log is.
struct LogCondition {
  bool finished = false;          ///< the footer is there: the writer came to its end
  bool torn = false;              ///< the file ends before the footer does: a crash or a full disk; the rest is sound
  std::uint64_t torn_offset = 0;  ///< end of the last complete record
  std::vector<Damage> damages;    ///< by offset
  std::vector<Gap> gaps;          ///< steps that were lost before the log was recovered from a damaged one

  /// Every byte is as it was written and the writer came to its end; a recovered log may have gaps all the same.
  [[nodiscard]] bool sound() const { return finished && !torn && damages.empty(); }

  /// Sound, and every step is there.
  [[nodiscard]] bool whole() const { return sound() && gaps.empty(); }

  /// One line for people: "whole", "torn at byte 8123 …", "2 records damaged, the first …". last_step: LogReader's.
  [[nodiscard]] std::string summary(std::uint64_t last_step) const;
};

/// What a walk from prelude to prelude finds, without index and footer.
struct Scan {
  std::vector<ChunkPlace> chunks;  ///< complete by length; their bytes are not hashed yet
  std::optional<ChunkPlace> index;
  std::optional<Footer> footer;
  std::uint64_t footer_offset = 0;
  LogCondition condition;
};

/// Walks the records behind the header. A record that is damaged is skipped: the walk goes on at the next prelude of
/// the same log. `gaps`: what the header says is missing.
Scan scan_records(const ByteSource& source, const Prelude& header, const std::vector<Gap>& gaps);

struct FoundPrelude {
  std::uint64_t offset = 0;
  Prelude prelude;
};

/// The first whole prelude at or after byte `from`: of the log with this tag, or of any if there is none.
std::optional<FoundPrelude> find_prelude(const ByteSource& source, std::uint64_t from,
                                         std::optional<std::uint64_t> log_tag);

}  // namespace tumble::replay
