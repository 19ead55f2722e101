#include "src/solve/apply_outcomes.h"

#include <algorithm>
#include <cmath>

#include "src/math/grid.h"
#include "src/world/body_check.h"

namespace tumble::sim {

LiftCost pay_for_lift(const Vec3& velocity, const Vec3& displacement, const Vec3& gravity) {
  const double pumped = -dot(gravity, displacement);  // J/kg
  if (pumped <= 0) return {velocity};
  const Vec3 up = gravity / -length(gravity);
  const double rise = dot(velocity, up);
  const double left = std::sqrt(std::max(0.0, rise * rise - 2 * pumped));
  const double new_rise = rise < 0 ? -left : left;
  const Vec3 slower = plus_zero(velocity + VelocityGrid::round(Vec3(up * (new_rise - rise))));
  return {slower, 0.5 * (dot(velocity, velocity) - dot(slower, slower))};
}

Status apply_outcomes(World& world, double /*dt_s*/) {
  Bodies& bodies = world.mutable_state().bodies;
  Scratch& scratch = world.mutable_scratch();
  const Vec3& gravity = world.state().def.gravity;
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (scratch.touched[i] == 0 || bodies.is_static[i] != 0) continue;
    Vec3 velocity = plus_zero(bodies.velocity[i] + scratch.velocity_gain[i]);
    bodies.spin.set(i, plus_zero(bodies.spin[i] + scratch.spin_gain[i]));
    if (bodies.moves(i)) {
      const Vec3 displacement = scratch.displacement[i];
      const LiftCost cost = pay_for_lift(velocity, displacement, gravity);
      velocity = cost.velocity;
      scratch.removed_energy += cost.removed * bodies.mass[i];
      bodies.position.set(i, plus_zero(bodies.position[i] + displacement));
    }
    bodies.velocity.set(i, velocity);
    if (Status ok = check_body(bodies, i); !ok.ok()) return ok;
  }
  return {};
}

void hash_apply_outcomes(const World& world, Hasher& hasher) {
  hash_motion(world, hasher);
  hasher.add(world.scratch().removed_energy);
}

}  // namespace tumble::sim
