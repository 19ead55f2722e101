#include "replay/measure/body_track.h"

#include <cmath>

#include "replay/format/not_finite.h"

namespace tumble::replay {
namespace {

// The top of free flight through this height and speed. Steps rarely hit the top of a bounce itself, and the highest
// step depends on where they fall: at dt 1/60 s it may lie 0.3 mm below. Energy gives the top from any state of the
// flight: m g h_top = m g h + ½ m v².
double top_of_flight(const TrackedMotion& motion, double pull) {
  return motion.height + motion.rise * motion.rise / (2 * pull);
}

}  // namespace

void BodyTrack::add(const TrackedMotion& now, double pull) {
  if (!started_) start(now, pull);
  const sim::Vec3 change = now.spin_momentum - first_momentum_;
  momentum_change_ = largest(momentum_change_, std::sqrt(sim::dot(change, change)));
  least_spin_energy_ = least(least_spin_energy_, now.spin_energy);
  spin_gain_ = largest(spin_gain_, now.spin_energy - least_spin_energy_);
  look_for_top(now, pull);
  last_rise_ = now.rise;
}

void BodyTrack::start(const TrackedMotion& now, double pull) {
  started_ = true;
  first_momentum_ = now.spin_momentum;
  first_momentum_length_ = std::sqrt(sim::dot(first_momentum_, first_momentum_));
  first_spin_energy_ = least_spin_energy_ = now.spin_energy;
  starts_rising_ = now.rise > 0;
  if (pull > 0) first_top_ = largest(0.0, top_of_flight(now, pull));
}

// A top is a sign change of the vertical speed from up to not up. The first one of a body that starts on its way up
// belongs to no bounce and is not counted.
void BodyTrack::look_for_top(const TrackedMotion& now, double pull) {
  if (!(pull > 0)) first_top_ = 0;
  if (first_top_ == 0 || !(last_rise_ > 0) || now.rise > 0) return;
  if (starts_rising_) {  // a session may begin on the way up; that first top follows no bounce
    starts_rising_ = false;
    return;
  }
  ++bounces_;
  height_change_ = largest(height_change_, std::fabs(top_of_flight(now, pull) - first_top_));
}

// Ratios to the first value. Without a first value there is no ratio, and a metric without a value passes no bound.
std::optional<double> BodyTrack::momentum_drift() const {
  if (first_momentum_length_ == 0) return std::nullopt;
  return momentum_change_ / first_momentum_length_;
}

std::optional<double> BodyTrack::spin_energy_gain() const {
  if (first_spin_energy_ == 0) return std::nullopt;
  return spin_gain_ / first_spin_energy_;
}

std::optional<double> BodyTrack::bounce_height_loss() const {
  if (bounces_ == 0 || first_top_ == 0) return std::nullopt;
  return height_change_ / first_top_;
}

}  // namespace tumble::replay
