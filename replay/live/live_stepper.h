#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <vector>

#include "replay/live/live_frame.h"
#include "replay/live/live_inputs.h"
#include "replay/live/live_logs.h"
#include "replay/live/live_pacer.h"
#include "replay/live/phase_times.h"
#include "tumble/replay/extras.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"
#include "tumble/threads/worker_threads.h"

namespace tumble::replay {

struct LiveOptions {
  std::string log;        ///< path of the first log
  LiveLogs::Begin begin;  ///< opens the first log, and one at each return to the start; called on both threads
  StatesMode states;      ///< of logs that continue an earlier one
  double dt = 1.0 / 60;   ///< of the scene, s
  unsigned threads = 1;   ///< to step with
  Pace pace;              ///< at the start
};

/// The work of the thread that steps a played session (live_session.h): takes steps, keeps the clock, changes the log,
/// and fills in the frame. For one thread; open() alone may be called on another before.
class LiveStepper {
 public:
  explicit LiveStepper(LiveOptions options);
  LiveStepper(const LiveStepper&) = delete;
  LiveStepper& operator=(const LiveStepper&) = delete;

  /// Opens the first log, on a thread whose floating-point environment it checks and restores. Errors: options.begin's.
  Status open();
  /// Call first on the session's thread.
  void begin();

  /// Takes a step, with inputs made by hand and the views seen since the step before. A step that fails ends the
  /// session: the frame says why. Precondition: can_step().
  void step(std::vector<sim::Command> inputs, const std::vector<View>& views);
  void set(const Pace& pace);
  void back(double seconds);  ///< LiveLogs::back
  void again();               ///< LiveLogs::again
  void show_contacts(bool on) { with_contacts_ = on; }
  /// Completes the log that is open. Errors: it or an earlier one could not be written.
  Status finish();

  [[nodiscard]] bool can_step() const { return frame_.ended.empty(); }
  [[nodiscard]] bool is_waiting() const { return pace_.paused || !can_step(); }
  [[nodiscard]] bool is_paused() const { return pace_.paused; }
  [[nodiscard]] std::chrono::steady_clock::time_point due() const;  ///< of the next step, unless it is waiting
  /// The state after the last step or change. Each call has a new serial number.
  const LiveFrame& frame();
  [[nodiscard]] const std::vector<SavedLog>& saved() const { return logs_.saved(); }

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] double now() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }
  void restart_clock() { pacer_ = LivePacer(options_.dt, pace_, now()); }
  void adopt_recorder();
  void change_log(const Status& changed);
  void end(const Error& error);
  Status check_arithmetic();
  void take_dt(std::vector<sim::Command>& inputs);
  void add_views(const std::vector<View>& views);
  std::vector<sim::Command> prepare(std::vector<sim::Command> given, double dt_s);

  LiveOptions options_;
  LiveLogs logs_;
  LiveInputs checker_;
  LivePacer pacer_;
  Pace pace_;
  PhaseTimes times_;
  std::map<sim::BodyId, sim::Texture> looks_;
  std::unique_ptr<WorkerThreads> workers_;
  LiveFrame frame_;
  Status failed_;  // the first log that could not be written
  Clock::time_point began_ = Clock::now();
  bool with_contacts_ = false;
};

}  // namespace tumble::replay
