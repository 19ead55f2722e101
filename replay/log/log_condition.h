#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tumble/replay/prelude.h"
#include "tumble/replay/step_record.h"

namespace tumble::replay {

/// A place of a log whose bytes changed after they were written.
struct Damage {
  RecordKind kind = RecordKind::kChunk;  ///< of the damaged record
  std::uint64_t offset = 0;              ///< of the record, or of the first byte outside every record
  std::string message;                   ///< names record, byte, found and wanted
};

/// How complete and how intact a log is.
struct LogCondition {
  bool finished = false;              ///< the footer exists, so the writer completed the log
  bool torn = false;                  ///< the file ends before the footer, as after a crash or with a full disk
  std::uint64_t torn_offset = 0;      ///< end of the last complete record
  std::string writer;                 ///< of a torn log: the process that is writing it now; "" where none is known
  std::vector<Damage> damages;        ///< by offset
  std::vector<MissingSteps> missing;  ///< steps that were lost before recovery from a damaged log

  /// Complete and without damage. Steps may still be missing in a recovered log.
  [[nodiscard]] bool sound() const { return finished && !torn && damages.empty(); }

  /// Sound, and no step is missing.
  [[nodiscard]] bool whole() const { return sound() && missing.empty(); }

  /// One line for people: "whole", "torn at byte 8123 …", "2 records damaged, the first …". last_step: as
  /// LogReader::last_step() returns it.
  [[nodiscard]] std::string summary(std::uint64_t last_step) const;
};

}  // namespace tumble::replay
