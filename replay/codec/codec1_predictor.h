#pragma once

#include <cmath>

/// The prediction of codec 1: the motion of a body between two stored states.
///
/// A log stores states to the bit, 113 bytes each, and most of these bits follow from the state before. Codec 1
/// predicts each body and stores only the difference, which is zero for a body in free flight and a few low bits for a
/// body that touched something (docs/log_format.md, "States"). Two predictions are tried. The first is free flight,
/// computed as the stepper computed it when the codec was made: equal bits then cost one flag. The second is for bodies
/// that touched something. Contact impulses cannot be predicted, so the new velocities are stored first, as differences
/// from the old ones; then position and orientation are predicted from the mean of old and new velocity, which is close
/// to what any integrator does. The largest component of the orientation is stored last, because the quaternion has
/// unit length.
///
/// The functions below are a copy of the stepper's, and stay as they are. The stepper in src/ may change; old logs
/// still decode with these lines. A change of one bit in a result needs a new codec with a new number and a file of its
/// own.
///
/// Uses + − × ÷ and sqrt only, so that all machines predict equal bits. Inputs may be any doubles, NaN included.
namespace tumble::replay::codec1 {

struct V3 {
  double x, y, z;
};
struct Q4 {
  double w, x, y, z;
};
/// A body before the interval.
struct Motion {
  V3 position;
  Q4 orientation;
  V3 velocity;
  V3 spin;
};

inline constexpr double kTurnMax = 0.25;  // rad that a body turns in one part
inline constexpr int kPartsMax = 8;       // faster bodies get a coarser prediction
inline constexpr int kIterationsMax = 16;
inline constexpr double kConverged = 1e-15;

inline V3 operator+(const V3& a, const V3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline V3 operator-(const V3& a, const V3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline V3 operator*(const V3& a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline V3 operator/(const V3& a, double s) { return {a.x / s, a.y / s, a.z / s}; }
inline double dot(const V3& a, const V3& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
inline V3 cross(const V3& a, const V3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline V3 scaled(const V3& a, const V3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline V3 divided(const V3& a, const V3& b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }

/// Rounds to 2^−exponent, halves to even.
template <int kExponent>
double round_to_grid(double a) {
  constexpr double kMagic = 6755399441055744.0 / static_cast<double>(1ULL << kExponent);
  return ((a + kMagic) - kMagic) + 0.0;
}
template <int kExponent>
V3 round_to_grid(const V3& a) {
  return {round_to_grid<kExponent>(a.x), round_to_grid<kExponent>(a.y), round_to_grid<kExponent>(a.z)};
}

inline Q4 normalised(const Q4& q) {
  const double n = std::sqrt(q.w * q.w + ((q.x * q.x + q.y * q.y) + q.z * q.z));
  return {q.w / n + 0.0, q.x / n + 0.0, q.y / n + 0.0, q.z / n + 0.0};
}

inline Q4 product(const Q4& a, const Q4& b) {
  return {a.w * b.w - ((a.x * b.x + a.y * b.y) + a.z * b.z), (a.w * b.x + a.x * b.w) + (a.y * b.z - a.z * b.y),
          (a.w * b.y + a.y * b.w) + (a.z * b.x - a.x * b.z), (a.w * b.z + a.z * b.w) + (a.x * b.y - a.y * b.x)};
}

struct Axes {
  V3 x, y, z;
};
inline Axes axes_of(const Q4& q) {
  return {{1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.w * q.z), 2 * (q.x * q.z - q.w * q.y)},
          {2 * (q.x * q.y - q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z + q.w * q.x)},
          {2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y)}};
}
inline V3 to_body(const Axes& axes, const V3& v) { return {dot(axes.x, v), dot(axes.y, v), dot(axes.z, v)}; }
inline V3 to_world(const Axes& axes, const V3& v) { return (axes.x * v.x + axes.y * v.y) + axes.z * v.z; }

inline V3 turned_back(const V3& v, const V3& h) {
  const double hh = dot(h, h);
  return (v * (1 - hh) + h * (2 * dot(h, v)) - cross(h, v) * 2) / (1 + hh);
}

inline V3 midpoint_spin(const V3& momentum, const V3& inverse_inertia, double dt) {
  V3 spin = scaled(inverse_inertia, momentum);
  for (int k = 0; k < kIterationsMax; ++k) {
    const V3 after = turned_back(momentum, spin * (0.5 * dt));
    const V3 next = scaled(inverse_inertia, (momentum + after) * 0.5);
    const V3 change = next - spin;
    spin = next;
    if (dot(change, change) <= kConverged * kConverged * dot(spin, spin)) break;
  }
  return spin;
}

/// Turns a free body: by the implicit midpoint rule of the stepper for boxes with different moments of inertia, by one
/// Cayley turn for cubes, static bodies and bodies that spin too fast.
inline void turn(Motion& motion, const V3& inertia, double dt) {
  int parts = 1;
  const double turn_squared = dot(motion.spin, motion.spin) * (dt * dt);
  while (parts <= kPartsMax && turn_squared > (kTurnMax * kTurnMax) * (static_cast<double>(parts) * parts)) parts *= 2;
  if ((inertia.x == inertia.y && inertia.y == inertia.z) || parts > kPartsMax) {
    const V3 h = motion.spin * (0.5 * dt);
    motion.orientation = normalised(product({1, h.x, h.y, h.z}, motion.orientation));
    return;
  }
  const V3 inverse_inertia = divided({1, 1, 1}, inertia);
  const Axes axes = axes_of(motion.orientation);
  const V3 momentum = to_world(axes, scaled(inertia, to_body(axes, motion.spin)));
  const double part = dt / parts;
  for (int k = 0; k < parts; ++k) {
    const V3 middle = midpoint_spin(to_body(axes_of(motion.orientation), momentum), inverse_inertia, part);
    const V3 h = middle * (0.5 * part);
    motion.orientation = normalised(product(motion.orientation, {1, h.x, h.y, h.z}));
  }
  const Axes after = axes_of(motion.orientation);
  motion.spin = round_to_grid<38>(to_world(after, scaled(inverse_inertia, to_body(after, momentum))));
}

inline V3 fall(const V3& velocity, const V3& gravity, double air_drag, double dt) {
  const V3 faster = velocity + round_to_grid<38>(gravity * dt);
  return air_drag > 0 ? round_to_grid<38>(faster / (1 + air_drag * dt)) : faster + V3{0, 0, 0};
}

/// Free flight for dt (s) under gravity (m/s²) with linear drag (1/s); inertia: principal moments, kg·m².
inline Motion fly(const Motion& before, const V3& inertia, const V3& gravity, double air_drag, double dt) {
  Motion after = before;
  after.velocity = fall(before.velocity, gravity, air_drag, dt);
  after.position = before.position + round_to_grid<36>((before.velocity + after.velocity) * (0.5 * dt));
  turn(after, inertia, dt);
  if (air_drag > 0) after.spin = round_to_grid<38>(after.spin / (1 + air_drag * dt));
  return after;
}

// A body that touched something: the new velocities are known, and the body moved with about the mean velocity.

inline V3 carried(const V3& position, const V3& v0, const V3& v1, double dt) {
  return position + (v0 + v1) * (0.5 * dt);
}
inline Q4 turned(const Q4& orientation, const V3& w0, const V3& w1, double dt) {
  const V3 h = (w0 + w1) * (0.25 * dt);
  return normalised(product({1, h.x, h.y, h.z}, orientation));
}

/// The fourth component of a unit quaternion, from the other three and its sign.
inline double fourth(double a, double b, double c, bool negative) {
  const double left = 1 - ((a * a + b * b) + c * c);
  const double size = left > 0 ? std::sqrt(left) : 0;
  return negative ? -size : size;
}

}  // namespace tumble::replay::codec1
