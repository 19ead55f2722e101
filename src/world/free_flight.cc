#include "src/world/free_flight.h"

#include "src/kernels/kernels_by_width.h"
#include "src/math/grid.h"
#include "src/world/body_columns.h"

namespace tumble::sim {
namespace {

constexpr double kTurnMax = 0.25;     // rad in one rotation; faster ones are taken in equal parts
constexpr int kPartsMax = 65536;      // 8,192 rad/s about each axis for a second
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
// L') / 2. Under a Cayley map by h w that is the equation I w + h w × I w = L, with h = dt/2 or close to it. Newton's
// method solves the equation; repeated substitution diverges where a long bar turns fast across its length. Whatever h
// is, L' is as long as L and the energy stays.
Vec3 midpoint_spin(const Vec3& momentum, const Vec3& inertia, const Vec3& inverse_inertia, double h) {
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

// The midpoint rule of a part of dt errs by order dt²: the momentum runs along the right curve in the body's frame, but
// too fast by dt²/12 Q, and the body falls short of the angle dt³ ρ |L| about L. With J = I⁻¹ and m = L in the body's
// frame,
//   Q = (J₁ − J₃)(J₂ − J₁) m₁² + (J₂ − J₁)(J₃ − J₂) m₂² + (J₃ − J₂)(J₁ − J₃) m₃²
//   ρ = ((J₁J₂ + J₂J₃ + J₃J₁) m·Jm − 2 J₁J₂J₃ m·m) / 12, the same in all parts.
// Both follow from the modified equation of the rule (backward error analysis) beside Magnus's series of the exact
// turn. Hairer and Vilmart (2006), Preprocessed discrete Moser-Veselov algorithm, correct a similar rule likewise. An
// error of order dt⁴ is left: at most 1.3e-4 of the turn for parts of a quarter radian, the most slender bars included.
// Sums are arranged so that exchanging the first two axes changes no bit.
class Correction {
 public:
  Correction(const Vec3& inverse_inertia, double part_s)
      : j_(inverse_inertia),
        differences_(j_.z() - j_.y(), j_.x() - j_.z(), j_.y() - j_.x()),
        weights_(differences_.y() * differences_.z(), differences_.z() * differences_.x(),
                 differences_.x() * differences_.y()),
        part_(part_s) {}

  // The h of midpoint_spin, from Q in the middle of the part. momentum: at its start, body frame.
  [[nodiscard]] double half_s(const Vec3& momentum) const {
    const Vec3& m = momentum;
    const Vec3 rate = scaled(differences_, {m.y() * m.z(), m.z() * m.x(), m.x() * m.y()});
    const Vec3 middle = m + rate * (0.5 * part_);
    const double excess = dot(weights_, scaled(middle, middle));
    return 0.5 * part_ * (1 - part_ * part_ * excess * (1.0 / 12.0));
  }

  // Half the angle of which one part falls short, divided by |L|.
  [[nodiscard]] double half_missing(const Vec3& momentum) const {
    const double pairs = (j_.x() * j_.z() + j_.y() * j_.z()) + j_.x() * j_.y(), product = (j_.x() * j_.y()) * j_.z();
    const double rate = pairs * dot(momentum, scaled(j_, momentum)) - 2 * product * dot(momentum, momentum);
    return rate * (part_ * part_ * part_) * (1.0 / 24.0);
  }

 private:
  Vec3 j_, differences_, weights_;
  double part_;
};

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
  const bool slow = turns_slowly(spin * (0.5 * dt_s));
  const Correction correction(inverse_inertia, part_s);
  Quat q = orientation;
  for (int k = 0; k < parts; ++k) {
    const Vec3 momentum = to_body(axes_of(q), momentum_W);
    const double half_s = slow ? 0.5 * part_s : correction.half_s(momentum);
    const Vec3 h = midpoint_spin(momentum, inertia, inverse_inertia, half_s) * half_s;
    q = normalised(product(q, {1, h.x(), h.y(), h.z()}));
  }
  if (!slow) q = turned(q, momentum_W * (correction.half_missing(to_body(axes, momentum_W)) * parts));
  const Axes after = axes_of(q);
  const Vec3 new_spin = to_world(after, scaled(inverse_inertia, to_body(after, momentum_W)));
  return {q, VelocityGrid::round_any(new_spin)};
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
