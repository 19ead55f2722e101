#include "tests/support/sample_log.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "replay/log/byte_memory.h"
#include "replay/log/verify.h"

namespace tumble::replay {

Bytes SampleLog::record(std::size_t number) const {
  const auto at = [&](std::size_t i) {
    return bytes.begin() + static_cast<std::ptrdiff_t>(i < records.size() ? records[i] : bytes.size());
  };
  return {at(number), at(number + 1)};
}

Bytes SampleLog::joined(const std::vector<std::size_t>& order) const {
  Bytes all;
  for (const std::size_t number : order) {
    const Bytes part = record(number);
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

std::uint64_t SampleLog::record_of(std::uint64_t byte) const {
  return *std::prev(std::upper_bound(records.begin(), records.end(), byte));
}

const SampleLog& sample_log() {
  static const SampleLog made = [] {
    SampleLog s;
    const sim::SceneDef scene = scene_with_inputs(24);
    s.bytes = record_to_memory(scene, {}, 6);
    s.states = simulate(scene);
    const Result<LogReader> log = open_memory(s.bytes);
    s.records.push_back(0);
    for (const ChunkPlace& place : log->chunks()) s.records.push_back(place.offset);
    s.records.push_back(log->chunks().back().offset + log->chunks().back().length);
    s.records.push_back(s.bytes.size() - kFooterBytes);
    return s;
  }();
  return made;
}

Result<RecoveredLog> recover_memory(const Bytes& damaged) {
  const MemorySource source(damaged);
  const auto written = std::make_shared<Bytes>();
  const Result<RecoverReport> report =
      recover_log(source, std::make_unique<MemoryByteSink>(written, "recovered.tumble"));
  if (!report.ok()) return report.error();
  Result<LogReader> log = open_memory(*written);
  EXPECT_TRUE(log.ok()) << log.error().message;
  if (!log.ok()) return log.error();
  const VerifyReport verified = verify(*log);
  EXPECT_TRUE(verified.condition.sound()) << verified.condition.summary(log->last_step());
  EXPECT_EQ(verified.steps_checked, report->steps);
  EXPECT_EQ(log->first_state(), report->first_state);
  EXPECT_EQ(log->last_step(), report->last_step);
  return RecoveredLog{*report, *written};
}

}  // namespace tumble::replay
