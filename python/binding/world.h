#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "python/binding/log_file.h"
#include "tumble/replay/recorder.h"
#include "tumble/replay/session.h"
#include "tumble/sim/world.h"
#include "tumble/threads/worker_threads.h"

namespace tumble::python {

/// How a session in Python begins.
struct WorldStart {
  std::string text;                    ///< of the scene, TOML
  std::string file;                    ///< its path, for messages and for the scene's name
  std::vector<std::string> overrides;  ///< "grid.rows=7"
  std::string log;                     ///< to record to; empty: no log
  std::string states = "all";
  std::string hashes = "all";
  std::uint64_t threads = 1;
};

/// How a session in Python goes on from a state of a log.
struct WorldGoesOn {
  std::uint64_t step = 0;              ///< of the state
  bool inputs = true;                  ///< apply the inputs that the log and its scene have after it
  std::optional<std::uint64_t> steps;  ///< planned after it; none: up to the planned end of the log
  std::string log;                     ///< to record to; empty: no log
  std::string states = "all";
  std::string hashes = "all";
  std::uint64_t threads = 1;
};

/// A session that Python steps, with or without a log. Several threads may call; one steps at a time.
class LiveWorld {
 public:
  /// Raises what parse_scene(), Session::start() and Recorder::start() say.
  explicit LiveWorld(const WorldStart& start);
  /// Raises what continuation_of() and Recorder::go_on() say.
  LiveWorld(LogFile& from, const WorldGoesOn& how);

  /// Applies an input before the coming step, after those of the scene. Tries it on a copy of the world first, so that
  /// a refused one harms nothing. Raises tumble.BadInput.
  void add_input(const sim::Command& command);

  /// One more than the highest id of a body so far, those that the scene throws in later among them.
  std::uint64_t next_id();

  /// Takes `count` steps. Raises tumble.CannotFinish when a step fails; the session is then over. Returns the number of
  /// steps taken: fewer if Ctrl-C came, whose exception is then Python's current one.
  std::uint64_t step(std::uint64_t count);

  /// Completes the log, if there is one; the world takes no more steps.
  std::optional<replay::LogSummary> finish();
  [[nodiscard]] bool is_finished() const { return finished_; }

  /// Runs work(world) without Python's lock.
  template <class Work>
  auto read(Work&& work) {
    return released([&] {
      const std::scoped_lock lock(mutex_);
      return work(world());
    });
  }
  /// The resolved scene.
  [[nodiscard]] const sim::SceneDef& scene() const;

 private:
  using Running = std::variant<replay::Session, std::unique_ptr<replay::Recorder>>;
  static Result<Running> begin(const WorldStart& start);
  static Result<Running> go_on(replay::LogReader& from, const WorldGoesOn& how);
  LiveWorld(Running running, std::uint64_t threads);
  [[nodiscard]] const sim::World& world() const;
  Status step_once();
  void note_id(const sim::Command& command);
  Status try_input(const sim::Command& command);
  [[nodiscard]] Status can_step() const;

  std::mutex mutex_;  // locked without Python's lock alone
  std::unique_ptr<WorkerThreads> threads_;
  Running running_;
  std::vector<sim::Command> inputs_;   // for the coming step
  std::optional<sim::World> preview_;  // the world with the inputs of the coming step; none before the first
  std::uint64_t highest_id_ = 0;
  std::optional<Error> failed_;
  bool finished_ = false;
};

void add_world(py::module_& module);

}  // namespace tumble::python
