#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "replay/recover/recover.h"
#include "tests/support/log_memory.h"
#include "tumble/replay/log_reader.h"

/// A small finished log to do damage to, and what belongs in it.
namespace tumble::replay {

struct SampleLog {
  Bytes bytes;
  std::vector<std::uint64_t> records;  ///< offsets: header, 4 chunks of 6 steps, index, footer
  std::vector<BodyStates> states;      ///< 0 … 24

  /// The bytes of a record; 0 is the header, 1 … 4 are chunks, 5 the index, 6 the footer.
  [[nodiscard]] Bytes record(std::size_t number) const;
  /// Records one after the other.
  [[nodiscard]] Bytes joined(const std::vector<std::size_t>& order) const;
  /// Offset of the record in which a byte lies.
  [[nodiscard]] std::uint64_t record_of(std::uint64_t byte) const;
};

const SampleLog& sample_log();

struct RecoveredLog {
  RecoverReport report;
  Bytes bytes;
};

/// Recovers a log from memory to memory and fails the test unless what was written verifies.
Result<RecoveredLog> recover_memory(const Bytes& damaged);

}  // namespace tumble::replay
