#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "replay/format/step_record.h"
#include "replay/log/log_reader.h"
#include "replay/log/log_writer.h"
#include "src/base/result.h"
#include "src/step/step.h"
#include "src/world/world.h"

namespace tumble::replay {

/// Called after each step with the steps done and planned; false stops, as at the end. May be empty.
using Progress = std::function<bool(std::uint64_t done, std::uint64_t total)>;

struct RecordOptions {
  StatesMode states;
  std::string scene_text;              ///< the scene's TOML, kept in the header
  std::vector<std::string> overrides;  ///< "world.dt=0.01", kept in the header
  sim::Transform transform;            ///< the session is that of the scene's image
};

/// How a session goes on from another one's state.
struct GoOnOptions {
  StatesMode states;
  std::optional<std::uint64_t> steps = std::nullopt;  ///< to plan after that state; none: up to the other's planned end
  std::optional<double> seconds = std::nullopt;       ///< the same in s of the dt that it has
  bool keep_inputs = true;                            ///< apply what the other log and its scene have after that state
};

/// Runs a session and writes its log, a step at a time.
class Recorder {
 public:
  /// Makes the world (state 0) and begins the log. Errors: create_world's, LogWriter::create's; no file is touched
  /// before the world stands.
  static Result<std::unique_ptr<Recorder>> start(const std::string& path, const sim::SceneDef& scene,
                                                 const RecordOptions& options);
  static Result<std::unique_ptr<Recorder>> start(std::unique_ptr<ByteSink> sink, const sim::SceneDef& scene,
                                                 const RecordOptions& options);

  /// Begins a log that goes on from state k of another one, to the bit as if that session had not stopped. Step numbers
  /// go on counting from k. The inputs that the other log has after k come again, then those of its scene that it did
  /// not reach, unless options.keep_inputs is false. scene() is what the new header says. Errors: the log's; a k that
  /// it does not have; another method version than this build's, or a state k that this build computes differently
  /// (kCannotFinish).
  static Result<std::unique_ptr<Recorder>> go_on(const std::string& path, LogReader& from, std::uint64_t k,
                                                 const GoOnOptions& options);
  static Result<std::unique_ptr<Recorder>> go_on(std::unique_ptr<ByteSink> sink, LogReader& from, std::uint64_t k,
                                                 const GoOnOptions& options);

  /// Applies the scene's inputs for the next step, then `live` ones, and steps. Errors: an input that the world refuses
  /// (named with its step), a step that fails (kCannotFinish), writing. The steps before it stay in the log; finish()
  /// still completes it unless writing failed.
  Status step(std::span<const sim::Command> live = {});

  /// Threads to step with; see World::use.
  void use(Workers* workers) { world_.use(workers); }

  [[nodiscard]] const sim::World& world() const { return world_; }
  /// The resolved scene; scene().steps is the number of the last step that is planned.
  [[nodiscard]] const sim::SceneDef& scene() const { return scene_; }

  /// Before a pause: puts the steps so far into the file.
  Status flush() { return writer_->flush(world_.state()); }

  /// Completes the log.
  Result<LogSummary> finish() { return writer_->finish(); }

 private:
  using CreateWriter =
      std::function<Result<std::unique_ptr<LogWriter>>(const LogHeader& header, const sim::WorldState& initial)>;
  static Result<std::unique_ptr<Recorder>> start_with(const CreateWriter& create, const sim::SceneDef& scene,
                                                      const RecordOptions& options);
  static Result<std::unique_ptr<Recorder>> go_on_with(const CreateWriter& create, LogReader& from, std::uint64_t k,
                                                      const GoOnOptions& options);
  Recorder(sim::SceneDef scene, sim::World world, std::unique_ptr<LogWriter> writer);
  Status apply_inputs(std::span<const sim::Command> live);

  sim::SceneDef scene_;
  std::size_t next_input_ = 0;
  sim::World world_;
  std::unique_ptr<LogWriter> writer_;
  sim::PhaseHashes hashes_;
  std::vector<sim::Command> applied_;  // before the current step; kept for its memory
};

/// Records scene.steps steps. A step that fails ends the session: the log is completed up to the step before, and the
/// error names the step, the file and what was saved.
Result<LogSummary> record_session(const std::string& path, const sim::SceneDef& scene, const RecordOptions& options,
                                  const Progress& progress = {});

}  // namespace tumble::replay
