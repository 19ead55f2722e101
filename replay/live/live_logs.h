#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "replay/log/session_clock.h"
#include "tumble/replay/log_writer.h"
#include "tumble/replay/recorder.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// A completed log of a played session.
struct SavedLog {
  std::string path;
  std::uint64_t first_state = 0;
  LogSummary summary;
};

/// The logs of a played session. One is open at a time. Going back and beginning again complete it and open another, so
/// nothing that was played is lost.
class LiveLogs {
 public:
  /// Opens a log at a path, at the session's start: state 0 of a scene, or a state of another log.
  using Begin = std::function<Result<std::unique_ptr<Recorder>>(const std::string& path)>;

  LiveLogs(Begin begin, StatesMode states) : begin_(std::move(begin)), states_(states) {}

  /// Opens the first log. Errors: begin's.
  Status open(const std::string& path);

  /// Completes the open log; none is open afterwards. Does nothing without one. Errors: Recorder::finish's.
  Status finish();
  /// Completes the open log and begins again at the session's start, in ROOT_again.tumble. Errors: finish's, begin's.
  Status again();
  /// Completes the open log and continues, in ROOT_from_STEP.tumble, from its last state that is `seconds` of simulated
  /// time old or older, without the inputs made by hand after it. Where the log begins later than that, from the log
  /// that it continues; at most back to the session's start. Errors: finish's, Recorder::go_on's.
  Status back(double seconds);

  /// Null where no log is open.
  [[nodiscard]] Recorder* recorder() const { return recorder_.get(); }
  [[nodiscard]] const std::string& path() const { return path_; }  ///< of the log that was opened last
  [[nodiscard]] const std::vector<SavedLog>& saved() const { return saved_; }

  void note_step(double dt_s);                                ///< call after each step
  [[nodiscard]] double time() const { return clock_.now(); }  ///< simulated since the session's start, s

 private:
  // A log of the present line: each continues the one before.
  struct Part {
    std::string path;
    std::uint64_t first_state = 0;
    std::vector<double> times;  // of its states, s
  };
  [[nodiscard]] std::string unused_path(const std::string& ending) const;
  Status accept(Result<std::unique_ptr<Recorder>> opened, const std::string& path, double time_s);

  Begin begin_;
  StatesMode states_;
  std::string root_;  // the first log's path without its ending
  std::string path_;
  std::unique_ptr<Recorder> recorder_;
  std::vector<Part> line_;
  SessionClock clock_;
  std::vector<SavedLog> saved_;
};

}  // namespace tumble::replay
