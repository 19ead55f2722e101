#include "src/solve/integrate.h"

#include "src/math/grid.h"
#include "src/world/body_check.h"

namespace tumble::sim {
namespace {

constexpr double kTurnMax = 0.25;     // rad in one rotation; faster ones are taken in equal parts
constexpr int kPartsMax = 1024;       // 256 rad a step; beyond, the midpoint iteration may stop short
constexpr int kIterationsMax = 16;    // of the midpoint; each gains about a digit at kTurnMax
constexpr double kConverged = 1e-15;  // relative

Vec3 scaled(const Vec3& a, const Vec3& b) { return a.cwiseProduct(b); }

// A vector of the body's frame before a turn by the half vector h (axis times tan of half the angle, in that frame),
// seen from the frame after it.
Vec3 turned_back(const Vec3& v, const Vec3& h) {
  const double hh = dot(h, h);
  return (v * (1 - hh) + h * (2 * dot(h, v)) - cross(h, v) * 2) / (1 + hh);
}

// The angular velocity, body frame, that carries angular momentum L through one turn of length dt so that both ends
// and the middle agree: w = I⁻¹ (L + L') / 2 with L' = L seen from the turned frame.
Vec3 midpoint_spin(const Vec3& momentum, const Vec3& inverse_inertia, double dt_s) {
  Vec3 spin = scaled(inverse_inertia, momentum);
  for (int k = 0; k < kIterationsMax; ++k) {
    const Vec3 after = turned_back(momentum, spin * (0.5 * dt_s));
    const Vec3 next = scaled(inverse_inertia, (momentum + after) * 0.5);
    const Vec3 change = next - spin;
    spin = next;
    if (dot(change, change) <= kConverged * kConverged * dot(spin, spin)) break;
  }
  return spin;
}

int part_count(const Vec3& spin, double dt_s) {
  const double turn_squared = dot(spin, spin) * (dt_s * dt_s);
  int parts = 1;
  while (parts < kPartsMax && turn_squared > (kTurnMax * kTurnMax) * (static_cast<double>(parts) * parts)) parts *= 2;
  return parts;
}

Vec3 fall(const Vec3& velocity, const WorldDef& def, double dt_s) {
  const Vec3 faster = velocity + VelocityGrid::round(Vec3(def.gravity * dt_s));
  return def.air_drag > 0 ? VelocityGrid::round(Vec3(faster / (1 + def.air_drag * dt_s))) : plus_zero(faster);
}

}  // namespace

Rotation rotate_freely(const Quat& orientation, const Vec3& spin, const Vec3& inertia, const Vec3& inverse_inertia,
                       double dt_s) {
  if (inertia.x() == inertia.y() && inertia.y() == inertia.z()) {
    return {rotated_by_half(orientation, spin * (0.5 * dt_s)), spin};
  }
  const Axes axes = axes_of(orientation);
  const Vec3 momentum_W = to_world(axes, scaled(inertia, to_body(axes, spin)));
  const int parts = part_count(spin, dt_s);
  const double part_s = dt_s / parts;
  Quat turned = orientation;
  for (int k = 0; k < parts; ++k) {
    const Vec3 middle = midpoint_spin(to_body(axes_of(turned), momentum_W), inverse_inertia, part_s);
    const Vec3 h = middle * (0.5 * part_s);
    turned = normalised(product(turned, {1, h.x(), h.y(), h.z()}));
  }
  const Axes after = axes_of(turned);
  const Vec3 new_spin = to_world(after, scaled(inverse_inertia, to_body(after, momentum_W)));
  return {turned, VelocityGrid::round(new_spin)};
}

void fly_freely(WorldState& state, BodyIndex i, double dt_s) {
  const WorldDef& def = state.def;
  Bodies& bodies = state.bodies;
  const Vec3 before = bodies.velocity[i];
  const Vec3 after = fall(before, def, dt_s);
  const Rotation rotation =
      rotate_freely(bodies.orientation[i], bodies.spin[i], bodies.inertia[i], bodies.inverse_inertia[i], dt_s);
  const double slower = 1 + def.air_drag * dt_s;
  bodies.velocity.set(i, after);
  bodies.position.set(i, plus_zero(bodies.position[i] + PositionGrid::round(Vec3((before + after) * (0.5 * dt_s)))));
  bodies.orientation.set(i, rotation.orientation);
  bodies.spin.set(i, def.air_drag > 0 ? VelocityGrid::round(Vec3(rotation.spin / slower)) : rotation.spin);
}

Status integrate(World& world, double dt_s) {
  Bodies& bodies = world.mutable_state().bodies;
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (!bodies.moves(i)) continue;
    fly_freely(world.mutable_state(), i, dt_s);
    if (Status ok = check_body(bodies, i); !ok.ok()) return ok;
  }
  return {};
}

void hash_integrate(const World& world, Hasher& hasher) { hash_motion(world, hasher); }

}  // namespace tumble::sim
