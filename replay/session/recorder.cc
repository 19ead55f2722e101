#include "tumble/replay/recorder.h"

#include <utility>

namespace tumble::replay {
namespace {

LogHeader header_of(const sim::SceneDef& scene, const RecordOptions& options) {
  LogHeader header = header_for(scene);
  header.states = options.states;
  header.hashes = options.hashes;
  header.transform = options.transform;
  header.scene_text = options.scene_text;
  header.overrides = options.overrides;
  return header;
}

/// The scene with the transform applied.
sim::SceneDef session_of(const sim::SceneDef& scene, const sim::Transform& transform) {
  return transform.identity() ? scene : image_of(scene, transform, ids_under(scene, transform));
}

/// Adds to the message of a failed step how much of the session is saved.
Error ended_early(const Error& error, const std::string& path, const Result<LogSummary>& saved) {
  if (!saved.ok() && saved.error().message == error.message) return error;  // writing itself failed
  if (!saved.ok()) return {error.kind, error.message + "; and " + saved.error().message};
  return {error.kind,
          error.message + "; " + path + " is complete with the " + std::to_string(saved->steps) + " steps before it"};
}

/// LogWriter::create() for a place: a path or a sink.
auto writer_to(const std::string& path) {
  return [&path](const LogHeader& header, const sim::WorldState& initial) {
    return LogWriter::create(path, header, initial);
  };
}

auto writer_to(std::unique_ptr<ByteSink>& sink) {
  return [&sink](const LogHeader& header, const sim::WorldState& initial) {
    return LogWriter::create(std::move(sink), header, initial);
  };
}

}  // namespace

Recorder::Recorder(Session session, std::unique_ptr<LogWriter> writer, HashesMode hashes_mode)
    : session_(std::move(session)), writer_(std::move(writer)), hashes_mode_(hashes_mode) {}

Result<std::unique_ptr<Recorder>> Recorder::write_with(const CreateWriter& create, const LogHeader& header,
                                                       Result<Session> session) {
  if (!session.ok()) return session.error();
  auto writer = create(header, session->world().state());
  if (!writer.ok()) return writer.error();
  return std::unique_ptr<Recorder>(new Recorder(*std::move(session), *std::move(writer), header.hashes));
}

Result<std::unique_ptr<Recorder>> Recorder::start_with(const CreateWriter& create, const sim::SceneDef& scene,
                                                       const RecordOptions& options) {
  sim::SceneDef transformed = session_of(scene, options.transform);
  const LogHeader header = header_of(transformed, options);
  return write_with(create, header, Session::start(std::move(transformed)));
}

Result<std::unique_ptr<Recorder>> Recorder::go_on_with(const CreateWriter& create, LogReader& from, std::uint64_t k,
                                                       const GoOnOptions& options) {
  Result<Continuation> continuation = continuation_of(from, k, options);
  if (!continuation.ok()) return continuation.error();
  const LogHeader& header = continuation->header;
  return write_with(create, header, Session::resume(std::move(continuation->state), header.scene));
}

Result<std::unique_ptr<Recorder>> Recorder::start(const std::string& path, const sim::SceneDef& scene,
                                                  const RecordOptions& options) {
  return start_with(writer_to(path), scene, options);
}

Result<std::unique_ptr<Recorder>> Recorder::start(std::unique_ptr<ByteSink> sink, const sim::SceneDef& scene,
                                                  const RecordOptions& options) {
  return start_with(writer_to(sink), scene, options);
}

Result<std::unique_ptr<Recorder>> Recorder::go_on(const std::string& path, LogReader& from, std::uint64_t k,
                                                  const GoOnOptions& options) {
  return go_on_with(writer_to(path), from, k, options);
}

Result<std::unique_ptr<Recorder>> Recorder::go_on(std::unique_ptr<ByteSink> sink, LogReader& from, std::uint64_t k,
                                                  const GoOnOptions& options) {
  return go_on_with(writer_to(sink), from, k, options);
}

// Hashes are taken inside the step, by an observer, because a phase's words hash scratch memory that the next phase
// overwrites. The writer copies what it needs before append() returns, so the spans may be used again.
Status Recorder::step(std::span<const sim::Command> live) {
  hashes_.clear();
  sim::Observer* const hashes = hashes_mode_.holds(session_.steps_done() + 1) ? &hashes_ : nullptr;
  const Result<TakenStep> taken = session_.step(live, watch_ ? watch_(hashes) : hashes);
  if (!taken.ok()) return taken.error();
  const Extras* extras = extras_.views.empty() ? nullptr : &extras_;
  Status written =
      writer_->append({taken->dt, taken->inputs, hashes_.words(), taken->counters, extras}, world().state());
  extras_.views.clear();
  return written;
}

Status Recorder::add_view(const View& view) {
  Extras one;
  one.views.push_back(view);
  if (Status ok = check_extras(one); !ok.ok()) return ok;
  extras_.views.push_back(view);
  return {};
}

Status Recorder::run(const Progress& progress) {
  const std::uint64_t first = session_.steps_done(), last = scene().steps;
  for (std::uint64_t k = first + 1; k <= last; ++k) {
    if (Status ok = step(); !ok.ok()) return ok;
    if (progress && !progress(k - first, last - first)) break;
  }
  return {};
}

Result<LogSummary> record_session(const std::string& path, const sim::SceneDef& scene, const RecordOptions& options,
                                  const Progress& progress) {
  Result<std::unique_ptr<Recorder>> recorder = Recorder::start(path, scene, options);
  if (!recorder.ok()) return recorder.error();
  const Status recorded = (*recorder)->run(progress);
  Result<LogSummary> saved = (*recorder)->finish();
  if (!recorded.ok()) return ended_early(recorded.error(), path, saved);
  return saved;
}

}  // namespace tumble::replay
