#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tumble/replay/continuation.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/log_writer.h"
#include "tumble/replay/progress.h"
#include "tumble/replay/session.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"
#include "tumble/sim/step.h"
#include "tumble/sim/world.h"

namespace tumble::replay {

struct RecordOptions {
  StatesMode states;
  HashesMode hashes = {};
  std::string scene_text;              ///< the scene's TOML, kept in the header
  std::vector<std::string> overrides;  ///< "world.dt=0.01", kept in the header
  sim::Transform transform;            ///< applied to the scene before the session starts
};

/// Runs a session and writes its log, one step at a time.
class Recorder {
 public:
  /// Makes the world (state 0) and begins the log. Creates the file only after the world. Errors:
  /// Session::start's, LogWriter::create's.
  static Result<std::unique_ptr<Recorder>> start(const std::string& path, const sim::SceneDef& scene,
                                                 const RecordOptions& options);
  static Result<std::unique_ptr<Recorder>> start(std::unique_ptr<ByteSink> sink, const sim::SceneDef& scene,
                                                 const RecordOptions& options);

  /// Begins a log that continues from state k of another log, to the bit as if that session had not stopped. Counts
  /// steps on from k. Applies again the inputs that the other log has after k, then the inputs of its scene that the
  /// other session did not reach; neither if options.keep_inputs is false. scene() is the scene in the new header.
  /// Errors: the log's; a k that the log does not have; a log of another method version, or a state k that this build
  /// computes differently (kCannotFinish).
  static Result<std::unique_ptr<Recorder>> go_on(const std::string& path, LogReader& from, std::uint64_t k,
                                                 const GoOnOptions& options);
  static Result<std::unique_ptr<Recorder>> go_on(std::unique_ptr<ByteSink> sink, LogReader& from, std::uint64_t k,
                                                 const GoOnOptions& options);

  /// Applies the scene's inputs for the next step, then `live`, and steps. Errors: an input that the world refuses (the
  /// message names input and step), a step that fails (kCannotFinish), writing. The steps before stay in the log;
  /// finish() still completes it unless writing failed.
  Status step(std::span<const sim::Command> live = {});

  /// Logs what is shown, with the coming step. Errors (kBadInput): a view that is none; see check_extras().
  Status add_view(const View& view);

  /// Takes the planned steps that are left. `progress` may stop early. Errors: step()'s.
  Status run(const Progress& progress = {});

  /// Sets the threads to step with; see World::use.
  void use(Workers* workers) { session_.use(workers); }

  /// Called before each step with the observer that hashes its phases, null in a step without hashes. Returns the
  /// observer of the step, which passes every call on to that one. Null: no other observer.
  using Watch = std::function<sim::Observer*(sim::Observer* hashes)>;
  void watch(Watch watch) { watch_ = std::move(watch); }

  [[nodiscard]] const sim::World& world() const { return session_.world(); }
  /// The resolved scene; scene().steps is the number of the last planned step.
  [[nodiscard]] const sim::SceneDef& scene() const { return session_.scene(); }

  /// Puts the steps so far into the file. Call before a pause.
  Status flush() { return writer_->flush(world().state()); }

  /// Completes the log.
  Result<LogSummary> finish() { return writer_->finish(); }

 private:
  using CreateWriter =
      std::function<Result<std::unique_ptr<LogWriter>>(const LogHeader& header, const sim::WorldState& initial)>;
  static Result<std::unique_ptr<Recorder>> start_with(const CreateWriter& create, const sim::SceneDef& scene,
                                                      const RecordOptions& options);
  static Result<std::unique_ptr<Recorder>> go_on_with(const CreateWriter& create, LogReader& from, std::uint64_t k,
                                                      const GoOnOptions& options);
  static Result<std::unique_ptr<Recorder>> write_with(const CreateWriter& create, const LogHeader& header,
                                                      Result<Session> session);
  Recorder(Session session, std::unique_ptr<LogWriter> writer, HashesMode hashes_mode);

  Session session_;
  std::unique_ptr<LogWriter> writer_;
  HashesMode hashes_mode_;
  sim::PhaseHashes hashes_;
  Extras extras_;  // of the coming step: views
  Watch watch_;
};

/// Records scene.steps steps. A step that fails ends the session: the log is completed up to the step before, and the
/// error names the step, the file and how many steps are saved.
Result<LogSummary> record_session(const std::string& path, const sim::SceneDef& scene, const RecordOptions& options,
                                  const Progress& progress = {});

}  // namespace tumble::replay
