#pragma once

#include <cstdint>

namespace tumble::replay {

/// Simulated time in s since state 0. Multiplies the length of equal steps instead of adding it up, so that 300 steps
/// of 1/60 s are exactly 5 s.
class SessionClock {
 public:
  void add_step(double dt_s) {
    if (dt_s != dt_) {
      begin_ = now();
      dt_ = dt_s;
      steps_ = 0;
    }
    ++steps_;
  }
  [[nodiscard]] double now() const { return begin_ + static_cast<double>(steps_) * dt_; }

 private:
  double dt_ = 0;            // s, each step of the current run of equal steps
  double begin_ = 0;         // s, time at which that run began
  std::uint64_t steps_ = 0;  // taken in that run
};

}  // namespace tumble::replay
