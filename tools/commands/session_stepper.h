#pragma once

#include <chrono>
#include <optional>

#include "replay/session/frame_clock.h"
#include "tumble/replay/recorder.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// Real time: whether a session follows the clock, and the longest step then, s (four frames if not given).
struct RealTime {
  bool on = false;
  std::optional<double> longest_step;
};

/// Takes the steps of a recorder: as fast as possible, or each as long as the time since the step before.
class SessionStepper {
 public:
  SessionStepper(replay::Recorder& recorder, const RealTime& realtime);

  /// Takes the next step; in real time, waits until the step is due. Errors: Recorder::step's.
  Status step();

  [[nodiscard]] double elapsed_s() const;
  /// Counts of the frames; none without real time.
  [[nodiscard]] std::optional<replay::Frames> frames() const;

 private:
  using Clock = std::chrono::steady_clock;

  replay::Recorder& recorder_;
  Clock::time_point begin_ = Clock::now();
  std::optional<replay::FrameClock> clock_;
};

}  // namespace tumble::tools
