#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "golden/engine/project.h"
#include "tools/output/progress.h"
#include "tumble/replay/divergence.h"
#include "tumble/replay/log_reader.h"

namespace tumble::tools {

/// Compares the session that an engine is writing with the log that it computes anew, while the engine runs. The steps
/// that are complete are read again and again, ever more seldom: a look costs at most a quarter of the time since the
/// last one.
class SessionWatch {
 public:
  /// log: outlives this. stop: look() asks for the engine's end at the first difference.
  SessionWatch(replay::LogReader& log, bool stop) : log_(log), stop_(stop), bar_("replaying") {}

  /// The file that the engine writes, and one for its conversion to a log. project: outlives the engine's run.
  void begin(const std::string& session, const std::string& converted, const golden::EngineProject& project);

  /// To be called often. Whether the engine is to be ended.
  bool look();

  /// Looks now. False: the session has no complete step yet.
  bool look_once();

  /// The first difference of the steps so far.
  [[nodiscard]] const std::optional<replay::Divergence>& first() const { return first_; }
  [[nodiscard]] bool wants_stop() const { return stop_ && first_.has_value(); }
  [[nodiscard]] const std::string& log_so_far() const { return so_far_; }  ///< of the last look; empty: none

 private:
  using Clock = std::chrono::steady_clock;

  replay::LogReader& log_;
  bool stop_;
  ProgressBar bar_;
  void warn_of_silence(Clock::time_point now);

  const golden::EngineProject* project_ = nullptr;
  std::string session_, converted_, so_far_;
  Clock::time_point next_;
  std::uint64_t last_step_ = 0;  // of the session so far
  Clock::time_point grown_;      // when it got a step
  bool warned_ = false;
  std::optional<replay::Divergence> first_;
};

}  // namespace tumble::tools
