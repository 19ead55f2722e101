#pragma once

#include <cstdint>
#include <vector>

#include "tools/live/hand.h"
#include "tools/output/text.h"

namespace tumble::tools {

/// `--measure`: plays without a person, and counts. The first second is left out, because drivers compile then.
class Measurement {
 public:
  explicit Measurement(double seconds) : seconds_(seconds) {}

  /// Call before each frame; now_s counts from the first. Throws boxes and turns the camera.
  void play(Hand& hand, ViewState& view, double now_s);
  /// Call after each frame is presented.
  void count(const replay::LiveFrame& frame, double draw_seconds, double now_s);
  [[nodiscard]] bool is_over(double now_s) const { return now_s >= seconds_; }

  [[nodiscard]] Json json(const Hand& hand) const;

 private:
  double seconds_;
  double thrown_at_ = 0;
  std::uint64_t throws_ = 0;
  double turned_at_ = 0;
  double begin_ = -1, end_ = 0;                     // of the counted time, s
  double simulated_begin_ = 0, simulated_end_ = 0;  // s
  std::uint64_t first_step_ = 0, last_step_ = 0;
  std::vector<double> frame_seconds_, draw_seconds_, step_seconds_;
};

}  // namespace tumble::tools
