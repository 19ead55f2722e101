#include "src/thesis/apply_outcomes.h"

#include <algorithm>
#include <cmath>

#include "src/math/grid.h"
#include "src/world/body_check.h"

namespace tumble::sim {

namespace {

// Gravity and the upward direction. Without gravity `up` is not a number; nothing reads it then.
struct Gravity {
  explicit Gravity(const Vec3& g) : gravity(g), up(g / -length(g)) {}
  Vec3 gravity, up;
};

inline LiftCost pay_for(const Vec3& velocity, const Vec3& displacement, const Gravity& g) {
  const double pumped = -dot(g.gravity, displacement);  // J/kg
  if (pumped <= 0) return {velocity};
  const double rise = dot(velocity, g.up);
  const double left = std::sqrt(std::max(0.0, rise * rise - 2 * pumped));
  const double new_rise = rise < 0 ? -left : left;
  const Vec3 slower = plus_zero(velocity + VelocityGrid::round(Vec3(g.up * (new_rise - rise))));
  return {slower, 0.5 * (dot(velocity, velocity) - dot(slower, slower))};
}

}  // namespace

LiftCost pay_for_lift(const Vec3& velocity, const Vec3& displacement, const Vec3& gravity) {
  return pay_for(velocity, displacement, Gravity(gravity));
}

Status apply_outcomes(WorldState& state, Scratch& scratch, double /*dt_s*/) {
  Bodies& bodies = state.bodies;
  const Gravity gravity(state.def.gravity);
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (scratch.touched[i] == 0 || bodies.is_static[i] != 0) continue;
    Vec3 velocity = plus_zero(bodies.velocity[i] + scratch.velocity_gain[i]), position = bodies.position[i];
    const Vec3 spin = plus_zero(bodies.spin[i] + scratch.spin_gain[i]);
    if (bodies.moves(i)) {
      if (!within(velocity, kSpeedMax)) {  // the grid of the lift ends there
        bodies.velocity.set(i, velocity);
        return check_body_closely(bodies, i);
      }
      const Vec3 displacement = scratch.displacement[i];
      const LiftCost cost = pay_for(velocity, displacement, gravity);
      velocity = cost.velocity;
      scratch.removed_energy += cost.removed * bodies.mass[i];
      position = plus_zero(position + displacement);
      bodies.position.set(i, position);
    }
    bodies.velocity.set(i, velocity);
    bodies.spin.set(i, spin);
    if (far_within_limits(position, velocity, spin)) continue;
    if (Status ok = check_body_closely(bodies, i); !ok.ok()) return ok;
  }
  return {};
}

void hash_apply_outcomes(const WorldState& state, const Scratch& scratch, Hasher& hasher) {
  hash_motion(state.bodies, hasher);
  hasher.add(scratch.removed_energy);
}

}  // namespace tumble::sim
