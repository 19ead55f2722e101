#include "src/world/free_flight.h"

#include "src/kernels/kernels_by_width.h"
#include "src/math/grid.h"
#include "src/world/body_columns.h"

namespace tumble::sim {
namespace {

constexpr double kTurnMax = 0.25;     // rad in one rotation; faster ones are taken in equal parts
constexpr int kPartsMax = 1024;       // 256 rad a step; beyond, the midpoint iteration may stop short
constexpr int kIterationsMax = 8;     // of the midpoint; each doubles the digits
constexpr double kConverged = 1e-15;  // relative

Vec3 scaled(const Vec3& a, const Vec3& b) { return a.cwiseProduct(b); }

// Newton's step for I w + h w × I w: the change of spin that removes the residual `off` to first order. The matrix is 3
// × 3. z is eliminated first, since exchanging x and y then exchanges the remaining two rows and columns and no bit of
// the result depends on which of the two axes is called x.
Vec3 newton_step(const Vec3& inertia, const Vec3& spin, double h, const Vec3& off) {
  const double ix = inertia.z() - inertia.y(), iy = inertia.x() - inertia.z(), iz = inertia.y() - inertia.x();
  const Vec3 w = spin * h;
  const double xz = w.y() * ix, yz = w.x() * iy, zx = w.y() * iz, zy = w.x() * iz, part = 1 / inertia.z();
  const double xx = inertia.x() - xz * (zx * part), xy = w.z() * ix - xz * (zy * part);
  const double yx = w.z() * iy - yz * (zx * part), yy = inertia.y() - yz * (zy * part);
  const double x = off.x() - xz * (off.z() * part), y = off.y() - yz * (off.z() * part);
  const double scale = 1 / (xx * yy - xy * yx);
  const double step_x = (x * yy - xy * y) * scale, step_y = (y * xx - yx * x) * scale;
  return {step_x, step_y, (off.z() - (zx * step_x + zy * step_y)) * part};
}

// The angular velocity w, body frame, in the middle of a turn of length dt. Angular momentum L stays fixed in the
// world, so from the frame before and after the turn it is seen as L and L'; the midpoint rule asks for w = I⁻¹ (L +
// L') / 2. Under a Cayley map that is the equation I w + dt/2 w × I w = L. Newton's method solves the equation;
// repeated substitution diverges where a long bar turns fast across its length.
Vec3 midpoint_spin(const Vec3& momentum, const Vec3& inertia, const Vec3& inverse_inertia, double dt_s) {
  const double h = 0.5 * dt_s;
  Vec3 w = scaled(inverse_inertia, momentum);
  for (int k = 0; k < kIterationsMax; ++k) {
    const Vec3 gyroscopic = {w.y() * w.z() * (inertia.z() - inertia.y()), w.z() * w.x() * (inertia.x() - inertia.z()),
                             w.x() * w.y() * (inertia.y() - inertia.x())};
    const Vec3 off = (scaled(inertia, w) - momentum) + gyroscopic * h;
    const Vec3 step = newton_step(inertia, w, h, off);
    w -= step;
    if (dot(step, step) <= kConverged * kConverged * dot(w, w)) break;
  }
  return w;
}

int part_count(const Vec3& spin, double dt_s) {
  const double turn_squared = dot(spin, spin) * (dt_s * dt_s);
  int parts = 1;
  while (parts < kPartsMax && turn_squared > (kTurnMax * kTurnMax) * (static_cast<double>(parts) * parts)) parts *= 2;
  return parts;
}

Air air_of(const WorldDef& def, double dt_s) {
  const Vec3 gain = VelocityGrid::round(Vec3(def.gravity * dt_s));
  return {dt_s, {gain.x(), gain.y(), gain.z()}, def.air_drag > 0, 1 + def.air_drag * dt_s};
}

Vec3 slowed(const Air& air, const Vec3& v) { return VelocityGrid::round(Vec3(v / air.slower)); }

}  // namespace

Rotation rotate_unevenly(const Quat& orientation, const Vec3& spin, const Vec3& inertia, const Vec3& inverse_inertia,
                         double dt_s) {
  const Axes axes = axes_of(orientation);
  const Vec3 momentum_W = to_world(axes, scaled(inertia, to_body(axes, spin)));
  const int parts = part_count(spin, dt_s);
  const double part_s = dt_s / parts;
  Quat turned = orientation;
  for (int k = 0; k < parts; ++k) {
    const Vec3 middle = midpoint_spin(to_body(axes_of(turned), momentum_W), inertia, inverse_inertia, part_s);
    const Vec3 h = middle * (0.5 * part_s);
    turned = normalised(product(turned, {1, h.x(), h.y(), h.z()}));
  }
  const Axes after = axes_of(turned);
  const Vec3 new_spin = to_world(after, scaled(inverse_inertia, to_body(after, momentum_W)));
  return {turned, VelocityGrid::round(new_spin)};
}

Flight free_flight(const WorldState& state, BodyIndex i, double dt_s) {
  const Air air = air_of(state.def, dt_s);
  const Bodies& bodies = state.bodies;
  const Vec3 before = bodies.velocity[i], faster = before + Vec3(air.gain[0], air.gain[1], air.gain[2]);
  const Vec3 after = air.drags ? slowed(air, faster) : plus_zero(faster);
  const Rotation rotation =
      rotate_freely(bodies.orientation[i], bodies.spin[i], bodies.inertia[i], bodies.inverse_inertia[i], dt_s);
  return {plus_zero(bodies.position[i] + PositionGrid::round(Vec3((before + after) * (0.5 * dt_s)))),
          rotation.orientation, after, air.drags ? slowed(air, rotation.spin) : rotation.spin};
}

void integrate_free(WorldState& state, LaneWidth lanes, Rows rows, const std::uint8_t* in_contact, double dt_s) {
  Bodies& bodies = state.bodies;
  const Air air = air_of(state.def, dt_s);
  if (!kernels(lanes).bodies.integrate_free(columns_of(bodies), rows, in_contact, air)) return;
  for (auto i = static_cast<BodyIndex>(rows.begin); i < rows.end; ++i) {
    if (!bodies.moves(i) || turns_evenly(bodies.inertia[i]) || (in_contact != nullptr && in_contact[i] != 0)) continue;
    const Flight flight = free_flight(state, i, dt_s);
    bodies.position.set(i, flight.position);
    bodies.orientation.set(i, flight.orientation);
    bodies.velocity.set(i, flight.velocity);
    bodies.spin.set(i, flight.spin);
  }
}

}  // namespace tumble::sim
