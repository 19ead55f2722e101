#include "tests/fuzz/use_log.h"

#include <algorithm>
#include <cstdlib>

#include "replay/log/log_facts.h"
#include "replay/log/verify.h"
#include "replay/measure/measure_log.h"
#include "replay/recover/recover.h"
#include "tumble/replay/replayer.h"

namespace tumble::fuzz {
namespace {

constexpr std::size_t kBodiesSimulated = 64;

/// What recovery writes must be sound, whatever it was made of.
void recover(const replay::MemoryFile& file) {
  const replay::MemoryByteSource source(file, "fuzzed.tumble");
  const auto written = std::make_shared<std::vector<std::byte>>();
  const Result<replay::RecoverReport> report =
      replay::recover_log(source, std::make_unique<replay::MemoryByteSink>(written, "recovered.tumble"));
  if (!report.ok()) return;
  Result<replay::LogReader> log =
      replay::LogReader::open(std::make_unique<replay::MemoryByteSource>(written, "recovered.tumble"));
  if (!log.ok() || !replay::verify(*log).condition.sound() || log->last_step() != report->last_step) std::abort();
}

}  // namespace

bool takes_a_moment(const replay::LogReader& log) {
  const sim::SceneDef& scene = log.header().scene;
  return scene.boxes.size() <= kBodiesSimulated && scene.world.substeps <= 16;
}

void use_log(const replay::MemoryFile& file) {
  recover(file);
  Result<replay::LogReader> log =
      replay::LogReader::open(std::make_unique<replay::MemoryByteSource>(file, "fuzzed.tumble"));
  if (!log.ok()) return;
  (void)replay::verify(*log).condition.summary(log->last_step());
  (void)replay::collect_facts(*log);
  const std::uint64_t last = std::min(log->last_step(), log->first_state() + kStepsSimulated);
  for (std::uint64_t k = log->first_state(); k <= last; ++k) (void)log->chain_at(k).ok();
  if (!takes_a_moment(*log)) return;
  const auto some = [](std::uint64_t done, std::uint64_t /*total*/) { return done < kStepsSimulated; };
  (void)replay::replay_log(*log, {}, some).ok();
  (void)replay::measure_log(*log, {}, {}, some).ok();
}

}  // namespace tumble::fuzz
