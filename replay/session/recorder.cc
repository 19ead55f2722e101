#include "replay/session/recorder.h"

#include <utility>

#include "replay/session/continuation.h"

namespace tumble::replay {
namespace {

LogHeader header_of(const sim::SceneDef& scene, const RecordOptions& options) {
  LogHeader header = header_for(scene);
  header.states = options.states;
  header.transform = options.transform;
  header.scene_text = options.scene_text;
  header.overrides = options.overrides;
  return header;
}

/// The scene as it is, or its image.
sim::SceneDef session_of(const sim::SceneDef& scene, const sim::Transform& transform) {
  return transform.identity() ? scene : image_of(scene, transform, ids_under(scene, transform));
}

/// What a failed step leaves behind, for its message.
Error ended_early(const Error& error, const std::string& path, const Result<LogSummary>& saved) {
  if (!saved.ok() && saved.error().message == error.message) return error;  // writing itself failed
  if (!saved.ok()) return {error.kind, error.message + "; and " + saved.error().message};
  return {error.kind,
          error.message + "; " + path + " is complete with the " + std::to_string(saved->steps) + " steps before it"};
}

}  // namespace

Recorder::Recorder(sim::SceneDef scene, sim::World world, std::unique_ptr<LogWriter> writer)
    : scene_(std::move(scene)), world_(std::move(world)), writer_(std::move(writer)) {}

Result<std::unique_ptr<Recorder>> Recorder::start(const std::string& path, const sim::SceneDef& scene,
                                                  const RecordOptions& options) {
  return start_with(
      [&](const LogHeader& header, const sim::WorldState& state) { return LogWriter::create(path, header, state); },
      scene, options);
}

Result<std::unique_ptr<Recorder>> Recorder::start(std::unique_ptr<ByteSink> sink, const sim::SceneDef& scene,
                                                  const RecordOptions& options) {
  return start_with([&](const LogHeader& header,
                        const sim::WorldState& state) { return LogWriter::create(std::move(sink), header, state); },
                    scene, options);
}

Result<std::unique_ptr<Recorder>> Recorder::start_with(const CreateWriter& create, const sim::SceneDef& scene,
                                                       const RecordOptions& options) {
  sim::SceneDef session = session_of(scene, options.transform);
  Result<sim::World> world = sim::create_world(session);
  if (!world.ok()) return world.error();
  auto writer = create(header_of(session, options), world->state());
  if (!writer.ok()) return writer.error();
  return std::unique_ptr<Recorder>(new Recorder(std::move(session), *std::move(world), *std::move(writer)));
}

Result<std::unique_ptr<Recorder>> Recorder::go_on(const std::string& path, LogReader& from, std::uint64_t k,
                                                  const GoOnOptions& options) {
  return go_on_with(
      [&](const LogHeader& header, const sim::WorldState& state) { return LogWriter::create(path, header, state); },
      from, k, options);
}

Result<std::unique_ptr<Recorder>> Recorder::go_on(std::unique_ptr<ByteSink> sink, LogReader& from, std::uint64_t k,
                                                  const GoOnOptions& options) {
  return go_on_with([&](const LogHeader& header,
                        const sim::WorldState& state) { return LogWriter::create(std::move(sink), header, state); },
                    from, k, options);
}

Result<std::unique_ptr<Recorder>> Recorder::go_on_with(const CreateWriter& create, LogReader& from, std::uint64_t k,
                                                       const GoOnOptions& options) {
  Result<Continuation> continuation = continuation_of(from, k, options);
  if (!continuation.ok()) return continuation.error();
  Result<sim::World> world = sim::World::restore(continuation->state);
  if (!world.ok()) return world.error();
  auto writer = create(continuation->header, world->state());
  if (!writer.ok()) return writer.error();
  return std::unique_ptr<Recorder>(new Recorder(continuation->header.scene, *std::move(world), *std::move(writer)));
}

Status Recorder::apply_inputs(std::span<const sim::Command> live) {
  const std::uint64_t step = world_.state().step + 1;
  applied_.clear();
  const std::vector<sim::TimedCommand>& inputs = scene_.inputs;
  while (next_input_ < inputs.size() && inputs[next_input_].step <= step) {
    applied_.push_back(inputs[next_input_++].command);
  }
  applied_.insert(applied_.end(), live.begin(), live.end());
  for (const sim::Command& command : applied_) {
    if (Status ok = sim::apply(world_, command); !ok.ok()) {
      return Error{ok.error().kind, "input \"" + std::string(sim::name_of(command)) + "\" before step " +
                                        std::to_string(step) + ": " + ok.error().message};
    }
  }
  return {};
}

Status Recorder::step(std::span<const sim::Command> live) {
  if (Status ok = apply_inputs(live); !ok.ok()) return ok;
  const double dt = world_.state().def.dt;
  hashes_.clear();
  Result<sim::StepCounters> counters = sim::step(world_, &hashes_);
  if (!counters.ok()) return counters.error();
  return writer_->append({dt, applied_, hashes_.words(), *counters}, world_.state());
}

Result<LogSummary> record_session(const std::string& path, const sim::SceneDef& scene, const RecordOptions& options,
                                  const Progress& progress) {
  Result<std::unique_ptr<Recorder>> recorder = Recorder::start(path, scene, options);
  if (!recorder.ok()) return recorder.error();
  for (std::uint64_t k = 1; k <= scene.steps; ++k) {
    if (Status ok = (*recorder)->step(); !ok.ok()) return ended_early(ok.error(), path, (*recorder)->finish());
    if (progress && !progress(k, scene.steps)) break;
  }
  return (*recorder)->finish();
}

}  // namespace tumble::replay
