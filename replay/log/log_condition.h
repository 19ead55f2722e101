#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "replay/format/prelude.h"
#include "replay/format/step_record.h"

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

}  // namespace tumble::replay
