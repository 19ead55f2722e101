#include "golden/canaries/lying_log.h"

#include <memory>
#include <utility>
#include <vector>

#include "tumble/replay/log_writer.h"
#include "tumble/replay/session.h"

namespace tumble::golden {

Result<replay::MemoryFile> record_lying(const sim::SceneDef& scene, std::uint64_t chunk, std::uint64_t lie_step,
                                        const Lie& lie) {
  auto file = std::make_shared<std::vector<std::byte>>();
  Result<replay::Session> session = replay::Session::start(scene);
  if (!session.ok()) return session.error();
  auto writer = replay::LogWriter::create(std::make_unique<replay::MemoryByteSink>(file, "the canary's log"),
                                          replay::header_for(scene), session->world().state());
  if (!writer.ok()) return writer.error();
  sim::PhaseHashes hashes;
  for (std::uint64_t k = 1; k <= scene.steps; ++k) {
    hashes.clear();
    Result<replay::TakenStep> taken = session->step({}, &hashes);
    if (!taken.ok()) return taken.error();
    sim::WorldState state = session->world().state();
    if (k == lie_step) lie(state, taken->counters);
    Status ok = (*writer)->append({taken->dt, taken->inputs, hashes.words(), taken->counters}, state);
    if (ok.ok() && k % chunk == 0) ok = (*writer)->flush(state);
    if (!ok.ok()) return ok.error();
  }
  const Result<replay::LogSummary> summary = (*writer)->finish();
  if (!summary.ok()) return summary.error();
  return file;
}

}  // namespace tumble::golden
