#pragma once

#include <cmath>
#include <vector>

#include "tumble/sim/vec.h"

namespace tumble::sim {

/// A unit quaternion, scalar first, that turns vectors from a body's axes to the world's: v_W = q v_B q*.
struct Quat {
  double w = 1, x = 0, y = 0, z = 0;
  friend bool operator==(const Quat&, const Quat&) = default;
};

/// A column of quaternions as four columns of doubles.
struct QuatColumn {
  std::vector<double> w, x, y, z;

  [[nodiscard]] std::size_t size() const { return w.size(); }
  Quat operator[](std::size_t i) const { return {w[i], x[i], y[i], z[i]}; }
  void set(std::size_t i, const Quat& q) {
    w[i] = q.w;
    x[i] = q.x;
    y[i] = q.y;
    z[i] = q.z;
  }
  void insert(std::size_t i, const Quat& q) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    w.insert(w.begin() + at, q.w);
    x.insert(x.begin() + at, q.x);
    y.insert(y.begin() + at, q.y);
    z.insert(z.begin() + at, q.z);
  }
  void erase(std::size_t i) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    w.erase(w.begin() + at);
    x.erase(x.begin() + at);
    y.erase(y.begin() + at);
    z.erase(z.begin() + at);
  }
  void clear() {
    w.clear();
    x.clear();
    y.clear();
    z.clear();
  }
  friend bool operator==(const QuatColumn&, const QuatColumn&) = default;
};

/// A rotation as the world directions of a body's own axes: R_WB's columns.
struct Axes {
  Vec3 axis[3];
  const Vec3& operator[](int k) const { return axis[k]; }
};

inline Axes axes_of(const Quat& q) {
  return {{Vec3(1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.w * q.z), 2 * (q.x * q.z - q.w * q.y)),
           Vec3(2 * (q.x * q.y - q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z + q.w * q.x)),
           Vec3(2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y))}};
}

/// A world vector expressed in the body's axes, and back.
inline Vec3 to_body(const Axes& axes, const Vec3& v) { return {dot(axes[0], v), dot(axes[1], v), dot(axes[2], v)}; }
inline Vec3 to_world(const Axes& axes, const Vec3& v) { return (axes[0] * v.x() + axes[1] * v.y()) + axes[2] * v.z(); }

inline double squared_length(const Quat& q) { return q.w * q.w + ((q.x * q.x + q.y * q.y) + q.z * q.z); }

/// q scaled to length 1. Precondition: q is finite and not zero.
inline Quat normalised(const Quat& q) {
  const double n = std::sqrt(squared_length(q));
  return {plus_zero(q.w / n), plus_zero(q.x / n), plus_zero(q.y / n), plus_zero(q.z / n)};
}

/// The Hamilton product a b: rotation a, then rotation b in a's own frame. Each component is summed in an order that
/// gives mirrored arguments the mirrored product, and swapped axes the swapped product, to the bit.
inline Quat product(const Quat& a, const Quat& b) {
  return {a.w * b.w - ((a.x * b.x + a.y * b.y) + a.z * b.z), (a.w * b.x + a.x * b.w) + (a.y * b.z - a.z * b.y),
          (a.w * b.y + a.y * b.w) + (a.z * b.x - a.x * b.z), (a.w * b.z + a.z * b.w) + (a.x * b.y - a.y * b.x)};
}

}  // namespace tumble::sim
