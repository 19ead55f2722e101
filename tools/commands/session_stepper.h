#pragma once

#include <chrono>
#include <optional>

#include "replay/session/frame_clock.h"
#include "replay/session/recorder.h"
#include "src/base/result.h"

namespace tumble::tools {

/// Whether a session follows the clock, and the longest step, s; four frames by default.
struct RealTime {
  bool on = false;
  std::optional<double> longest_step;
};

/// Takes the steps of a session: as fast as possible, or each as long as the last frame took on the clock.
class SessionStepper {
 public:
  SessionStepper(replay::Recorder& recorder, const RealTime& realtime);

  /// Waits until the next step is due, if one is, and takes it. Errors: Recorder::step's.
  Status step();

  [[nodiscard]] double elapsed_s() const;
  /// The frames of a session in real time; none for others.
  [[nodiscard]] std::optional<replay::Frames> frames() const;

 private:
  using Clock = std::chrono::steady_clock;

  replay::Recorder& recorder_;
  Clock::time_point begin_ = Clock::now();
  std::optional<replay::FrameClock> clock_;
};

}  // namespace tumble::tools
