#pragma once

#include <algorithm>
#include <cstdint>

namespace tumble::replay {

/// Frames of a session in real time.
struct Frames {
  std::uint64_t met = 0;      ///< done before the next one was due
  std::uint64_t missed = 0;   ///< not
  std::uint64_t bounded = 0;  ///< whose step is shorter than the time that had passed
  double longest_s = 0;       ///< that one took to compute
};

/// Turns time on the clock into steps, as the thesis's demonstration does: a frame is due every period, and its step is
/// the time since the frame before it began. A frame that takes longer makes the next step longer, which may make that
/// frame slower still; so a step is never longer than a bound, and from there on the session falls behind the clock. It
/// looks at no clock itself: times come from the caller, s, from any origin.
class FrameClock {
 public:
  /// The first frame begins now.
  FrameClock(double period_s, double longest_step_s, double now_s)
      : period_(period_s), longest_step_(longest_step_s), due_(now_s), began_(now_s - period_s) {}

  /// When the next frame is due; it is the caller's to wait for that.
  [[nodiscard]] double due() const { return due_; }

  /// A frame begins. Returns its step, s.
  double begin(double now_s) {
    const double passed = now_s - began_;
    if (passed > longest_step_) ++frames_.bounded;
    began_ = now_s;
    due_ = now_s + period_;
    return std::clamp(passed, std::min(period_ / 2, longest_step_), longest_step_);
  }

  /// It is done.
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
