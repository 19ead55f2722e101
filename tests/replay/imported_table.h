#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "replay/import/csv/import_csv.h"
#include "replay/log/byte_memory.h"
#include "tests/support/log_memory.h"

namespace tumble::replay {

/// Columns of a table that an engine writes.
inline constexpr const char* kPose =
    "position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z";
inline constexpr const char* kMotion = ",velocity.x,velocity.y,velocity.z,spin.x,spin.y,spin.z";

/// The log that an import makes in memory of the text of a table, t.csv.
inline Result<LogReader> import(const std::string& text, const ImportOptions& options = {}) {
  const MemoryFile file = std::make_shared<std::vector<std::byte>>();
  const auto sink = [&]() -> Result<std::unique_ptr<ByteSink>> {
    return std::unique_ptr<ByteSink>(std::make_unique<MemoryByteSink>(file, "t.tumble"));
  };
  const Result<LogSummary> summary = import_csv(text, "t.csv", sink, options);
  if (!summary.ok()) return summary.error();
  return LogReader::open(std::make_unique<MemoryByteSource>(file, "t.tumble"));
}

inline LogReader must_import(const std::string& text, const ImportOptions& options = {}) {
  Result<LogReader> log = import(text, options);
  EXPECT_TRUE(log.ok()) << log.error().message;
  return *std::move(log);
}

inline std::string error_of(const std::string& text, const ImportOptions& options = {}) {
  const Result<LogReader> log = import(text, options);
  return log.ok() ? "no error" : log.error().message;
}

}  // namespace tumble::replay
