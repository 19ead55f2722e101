#include "golden/run/run_session.h"

#include <chrono>
#include <memory>
#include <utility>

#include "tumble/replay/recorder.h"

namespace tumble::golden {

Result<Session> run_session(const sim::SceneDef& scene, const std::string& scene_text) {
  const auto begin = std::chrono::steady_clock::now();
  Session session{.log = std::make_shared<std::vector<std::byte>>(), .continuation = {}, .failure = {}};
  replay::RecordOptions options;
  options.scene_text = scene_text;
  auto sink = std::make_unique<replay::MemoryByteSink>(session.log, scene.name);
  auto recorder = replay::Recorder::start(std::move(sink), scene, options);
  if (!recorder.ok()) return recorder.error();
  if (const Status ok = (*recorder)->run(); !ok.ok()) session.failure = ok.error().message;
  session.continuation = sim::continuation_hash((*recorder)->world().state());
  const Result<replay::LogSummary> summary = (*recorder)->finish();
  if (!summary.ok() && session.failure.empty()) return summary.error();
  session.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return session;
}

Result<replay::LogReader> open_session(const Session& session, const std::string& name) {
  return replay::LogReader::open(std::make_unique<replay::MemoryByteSource>(session.log, name));
}

}  // namespace tumble::golden
