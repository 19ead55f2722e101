#pragma once

#include <algorithm>
#include <cstdint>

#include "src/base/check.h"

namespace tumble::replay {

/// Counts of the frames of a session in real time.
struct Frames {
  std::uint64_t met = 0;      ///< finished before the next frame was due
  std::uint64_t missed = 0;   ///< finished later
  std::uint64_t bounded = 0;  ///< steps shortened to the longest one allowed
  double longest_s = 0;       ///< the longest time that a frame took to compute
  double behind_s = 0;        ///< time on the clock that those steps left out
};

/// Turns time on a clock into steps, as the thesis's demonstration does. A frame is due every period. Its step is the
/// time from the start of the frame before to its own start. A slow frame makes the next step longer, and a longer
/// step may take longer to compute. Steps therefore have a longest length; beyond it the session falls behind the
/// clock. The caller reads the clock and passes the times, s, from any origin.
class FrameClock {
 public:
  /// The first frame is due at now_s. period_s and longest_step_s must be positive.
  FrameClock(double period_s, double longest_step_s, double now_s)
      : period_(period_s), longest_step_(longest_step_s), due_(now_s), began_(now_s - period_s) {
    SIM_CHECK(period_s > 0 && longest_step_s > 0, period_s, longest_step_s);
  }

  /// The time at which the next frame is due. The caller waits until then.
  [[nodiscard]] double due() const { return due_; }

  /// Begins a frame. Returns its step, s: at least half a period, at most the longest step.
  double begin(double now_s) {
    const double passed = now_s - began_;
    if (passed > longest_step_) {
      ++frames_.bounded;
      frames_.behind_s += passed - longest_step_;
    }
    began_ = now_s;
    due_ = now_s + period_;
    return std::clamp(passed, std::min(period_ / 2, longest_step_), longest_step_);
  }

  /// Ends the frame.
  void end(double now_s) {
    ++(now_s <= due_ ? frames_.met : frames_.missed);
    frames_.longest_s = std::max(frames_.longest_s, now_s - began_);
  }

  [[nodiscard]] const Frames& frames() const { return frames_; }

 private:
  double period_, longest_step_;
  double due_, began_;
  Frames frames_;
};

}  // namespace tumble::replay
