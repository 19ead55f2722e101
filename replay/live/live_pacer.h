#pragma once

#include "replay/session/frame_clock.h"

namespace tumble::replay {

/// How time passes in a session that is played.
struct Pace {
  bool paused = false;
  double speed = 1;   ///< simulated over real time, kSpeedLeast … 1; below 1: slow motion
  bool even = false;  ///< every step is dt long; else as long as the time since the step before, as in `--realtime`
  friend bool operator==(const Pace&, const Pace&) = default;
};
inline constexpr double kSpeedLeast = 1.0 / 64;

/// Says when the next step is due and how long it is. The caller reads the clock and passes the times, s.
class LivePacer {
 public:
  /// The first step is due at now_s. dt_s: of the scene; the steps of slow motion are shorter.
  LivePacer(double dt_s, const Pace& pace, double now_s);

  /// The time at which the next step is due.
  [[nodiscard]] double due() const { return clock_.due(); }
  /// Begins a step. Returns its length, s, within the limits of the simulation.
  double begin(double now_s);
  void end(double now_s) { clock_.end(now_s); }

  [[nodiscard]] const Frames& frames() const { return clock_.frames(); }

 private:
  double dt_;
  Pace pace_;
  FrameClock clock_;
};

}  // namespace tumble::replay
