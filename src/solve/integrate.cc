#include "src/solve/integrate.h"

#include <utility>

#include "src/math/grid.h"
#include "src/world/body_check.h"
#include "src/world/body_kernels.h"

namespace tumble::sim {
namespace {

constexpr double kTurnMax = 0.25;     // rad in one rotation; faster ones are taken in equal parts
constexpr int kPartsMax = 1024;       // 256 rad a step; beyond, the midpoint iteration may stop short
constexpr int kIterationsMax = 8;     // of the midpoint; each doubles the digits
constexpr double kConverged = 1e-15;  // relative

Vec3 scaled(const Vec3& a, const Vec3& b) { return a.cwiseProduct(b); }

// The change of spin that takes what is off of I w + h w × I w, to first order. z is eliminated first: its row and
// column are the only ones that differ from each other's mirror image under an exchange of x and y.
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

// The angular velocity, body frame, that carries angular momentum L through one turn of length dt so that both ends
// and the middle agree: w = I⁻¹ (L + L') / 2 with L' = L seen from the turned frame, which under a Cayley map is
// I w + dt/2 w × I w = L. By Newton: repeated substitution diverges where a bar turns fast across its length.
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

Vec3 fall(const Vec3& velocity, const WorldDef& def, double dt_s) {
  const Vec3 faster = velocity + VelocityGrid::round(Vec3(def.gravity * dt_s));
  return def.air_drag > 0 ? VelocityGrid::round(Vec3(faster / (1 + def.air_drag * dt_s))) : plus_zero(faster);
}

bool turns_alike(const Vec3& inertia) { return inertia.x() == inertia.y() && inertia.y() == inertia.z(); }

void fly_one(WorldState& state, BodyIndex i, double dt_s) {
  const Flight flight = free_flight(state, i, dt_s);
  Bodies& bodies = state.bodies;
  bodies.position.set(i, flight.position);
  bodies.orientation.set(i, flight.orientation);
  bodies.velocity.set(i, flight.velocity);
  bodies.spin.set(i, flight.spin);
}

// Those that turn alike about every axis; returns where it stopped, and how many of the others there are before.
std::pair<std::size_t, std::size_t> fly_in_lanes(World& world, const std::vector<std::uint8_t>& flies,
                                                 std::size_t begin, std::size_t end, double dt_s) {
  const BodyKernels* lanes = body_kernels(world.scratch().lanes);
  if (lanes == nullptr) return {begin, 0};
  const WorldDef& def = world.state().def;
  Bodies& bodies = world.mutable_state().bodies;
  Vec3Column &x = bodies.position, &v = bodies.velocity, &w = bodies.spin;
  QuatColumn& q = bodies.orientation;
  const Vec3Column& inertia = bodies.inertia;
  const Vec3 fall = VelocityGrid::round(Vec3(def.gravity * dt_s));
  std::size_t uneven = 0;
  const std::size_t stop = lanes->fly({begin,
                                       end,
                                       flies.data(),
                                       {x.x.data(), x.y.data(), x.z.data()},
                                       {q.w.data(), q.x.data(), q.y.data(), q.z.data()},
                                       {v.x.data(), v.y.data(), v.z.data()},
                                       {w.x.data(), w.y.data(), w.z.data()},
                                       {inertia.x.data(), inertia.y.data(), inertia.z.data()},
                                       {fall.x(), fall.y(), fall.z()},
                                       1 + def.air_drag * dt_s,
                                       dt_s},
                                      uneven);
  return {stop, uneven};
}

}  // namespace

Rotation rotate_freely(const Quat& orientation, const Vec3& spin, const Vec3& inertia, const Vec3& inverse_inertia,
                       double dt_s) {
  if (turns_alike(inertia)) {
    return {rotated_by_half(orientation, spin * (0.5 * dt_s)), spin};
  }
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
  const WorldDef& def = state.def;
  const Bodies& bodies = state.bodies;
  const Vec3 before = bodies.velocity[i], after = fall(before, def, dt_s);
  const Rotation rotation =
      rotate_freely(bodies.orientation[i], bodies.spin[i], bodies.inertia[i], bodies.inverse_inertia[i], dt_s);
  const double slower = 1 + def.air_drag * dt_s;
  return {plus_zero(bodies.position[i] + PositionGrid::round(Vec3((before + after) * (0.5 * dt_s)))),
          rotation.orientation, after,
          def.air_drag > 0 ? VelocityGrid::round(Vec3(rotation.spin / slower)) : rotation.spin};
}

void fly_freely(World& world, const std::vector<std::uint8_t>& flies, std::size_t begin, std::size_t end, double dt_s) {
  const auto [stop, uneven] = fly_in_lanes(world, flies, begin, end, dt_s);
  const Vec3Column& inertia = world.bodies().inertia;
  for (std::size_t i = uneven > 0 ? begin : stop; i < end; ++i) {
    if (flies[i] == 0 || (i < stop && turns_alike(inertia[i]))) continue;
    fly_one(world.mutable_state(), static_cast<BodyIndex>(i), dt_s);
  }
}

Status integrate(World& world, double dt_s) {
  const Bodies& bodies = world.bodies();
  std::vector<std::uint8_t>& flies = world.mutable_scratch().flies;
  flies.resize(bodies.size());
  for (BodyIndex i = 0; i < bodies.size(); ++i) flies[i] = bodies.moves(i) ? 1 : 0;
  fly_freely(world, flies, 0, bodies.size(), dt_s);
  return check_moving(world);
}

void hash_integrate(const World& world, Hasher& hasher) { hash_motion(world, hasher); }

}  // namespace tumble::sim
