#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>

#include "tumble/replay/engine_log.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/rotation.h"

/// Rotations from Euler angles, and velocities from positions, for tables that lack quaternions or velocities.
namespace tumble::replay {

/// A sequence of three axes. Capital letters (intrinsic): each turn is about the axes as the turns before left them.
/// Small letters (extrinsic): about the world's axes. "XYZ" turns about x, then the new y, then the new z.
struct EulerOrder {
  std::array<int, 3> axes = {0, 1, 2};
  bool intrinsic = true;
};

/// Reads "XYZ", "zyx" and so on. None: other letters, two equal neighbours, mixed case.
std::optional<EulerOrder> parse_euler(std::string_view text);

/// The orientation after three turns, by sin_cos_degrees(). angles: degrees, in the order of the axes. A number that is
/// not finite gives an orientation of NaN.
sim::Quat orientation_of(const EulerOrder& order, const std::array<double, 3>& degrees);

/// The angular velocity that turns one orientation to the other in dt, s: the shorter way.
sim::Vec3 spin_between(const sim::Quat& from, const sim::Quat& to, double dt);

/// Derives velocities and spins from the states of two steps. A body without a state in the step before has none: 0.
class DerivedMotion {
 public:
  /// Fills in what the table lacks. dt: s, since the step before.
  void derive(sim::BodyId id, std::uint64_t step, double dt, bool velocity, bool spin, EngineState& state);

 private:
  struct Before {
    std::uint64_t step = 0;
    sim::Vec3 position = {0, 0, 0};
    sim::Quat orientation;
  };
  std::map<sim::BodyId, Before> before_;
};

}  // namespace tumble::replay
