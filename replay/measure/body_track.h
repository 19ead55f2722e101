#pragma once

#include <cstdint>
#include <optional>

#include "tumble/sim/vec.h"

namespace tumble::replay {

/// One body after one step.
struct TrackedMotion {
  double height = 0;        ///< m, of its centre above its height when it lies on its largest face
  double rise = 0;          ///< m/s, upwards
  sim::Vec3 spin_momentum;  ///< kg·m²/s, about its centre, world axes
  double spin_energy = 0;   ///< J
};

/// Follows one body through all steps and measures how well free rotation keeps its momentum and energy and how well
/// bounces keep their height. docs/metrics.md has the formulas.
class BodyTrack {
 public:
  /// Takes the states in order; the first is the one that later ones are compared with. pull: gravity downwards, m/s².
  /// A pull of 0 or less ends the counting of bounces.
  void add(const TrackedMotion& now, double pull);

  [[nodiscard]] std::optional<double> momentum_drift() const;      ///< none without angular velocity at the start
  [[nodiscard]] std::optional<double> spin_energy_gain() const;    ///< none without angular velocity at the start
  [[nodiscard]] std::optional<double> bounce_height_loss() const;  ///< none before the first bounce
  [[nodiscard]] std::uint64_t bounces() const { return bounces_; }

 private:
  void start(const TrackedMotion& now, double pull);
  void look_for_top(const TrackedMotion& now, double pull);

  bool started_ = false;
  sim::Vec3 first_momentum_ = {0, 0, 0};
  double first_momentum_length_ = 0;
  double momentum_change_ = 0;
  double first_spin_energy_ = 0;
  double least_spin_energy_ = 0;
  double spin_gain_ = 0;

  double first_top_ = 0;  // m; 0 where there is nothing to bounce from
  bool starts_rising_ = false;
  double last_rise_ = 0;
  double height_change_ = 0;
  std::uint64_t bounces_ = 0;
};

}  // namespace tumble::replay
