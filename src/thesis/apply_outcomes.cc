#include "src/thesis/apply_outcomes.h"

#include <algorithm>
#include <cmath>

#include "src/math/grid.h"
#include "src/math/lift_cost.h"
#include "src/thesis/split_mass.h"
#include "src/world/body_check.h"
#include "src/world/hash_on_the_way.h"

namespace tumble::sim {

namespace {

// Takes `unpaid`, J/kg, from the rotation of body i, as far as there is any. Returns the energy taken, J.
double pay_by_rotation(const Bodies& bodies, const BoxFrame& frame, BodyIndex i, double unpaid, Vec3& spin) {
  const double rotation = 0.5 * gain_energy(bodies, frame, i, Vec3::Zero(), spin), price = unpaid * bodies.mass[i];
  if (rotation <= 0) return 0;
  spin = plus_zero(VelocityGrid::round(Vec3(spin * std::sqrt(std::max(0.0, 1 - price / rotation)))));
  return rotation - 0.5 * gain_energy(bodies, frame, i, Vec3::Zero(), spin);
}

}  // namespace

Status apply_outcomes(WorldState& state, Scratch& scratch, double /*dt_s*/) {
  Bodies& bodies = state.bodies;
  const Vec3 vertical =
      state.def.gravity / -length(state.def.gravity);  // not a number without gravity: never read then
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (scratch.touched[i] == 0 || bodies.is_static[i] != 0) continue;
    const Gain& gain = scratch.gains[i];
    Vec3 velocity = plus_zero(bodies.velocity[i] + gain.velocity), position = bodies.position[i];
    Vec3 spin = plus_zero(bodies.spin[i] + gain.spin);
    if (bodies.moves(i)) {
      if (!within(velocity, kSpeedMax)) {  // the grid of the lift ends there
        bodies.velocity.set(i, velocity);
        return check_body_closely(bodies, i);
      }
      const Vec3 displacement = scratch.displacement[i];
      Vec3 up = vertical;
      if ((scratch.hit[i] & kHit) == 0) up = displacement / length(displacement);
      const LiftCost cost = pay_for_lift(velocity, displacement, state.def.gravity, up);
      velocity = cost.velocity;
      scratch.removed_energy += cost.removed * bodies.mass[i];
      if ((scratch.hit[i] & kBouncesFully) != 0 && cost.unpaid > 0) {
        scratch.removed_energy += pay_by_rotation(bodies, scratch.frames[i], i, cost.unpaid, spin);
      }
      position = plus_zero(position + (displacement + gain.way_back));
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
  const Bodies& bodies = state.bodies;
  add_touched(scratch, hasher, [&](GatheredNumbers& numbers, BodyIndex i) {
    numbers.add(Vec3(bodies.position[i]));
    numbers.add(Vec3(bodies.velocity[i]));
    numbers.add(Vec3(bodies.spin[i]));
  });
  hasher.add(scratch.removed_energy);
}

}  // namespace tumble::sim
