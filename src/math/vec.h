#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace tumble::sim {

/// A vector of three coefficients. Eigen stores vectors and adds them coefficient by coefficient; dot and cross
/// products are written out below in one parenthesised order, since the order of Eigen's own reductions depends on the
/// vector width. The sum (x + y) + z keeps its bits when x and y are exchanged, and negating every component negates
/// the sum: mirror and swap symmetry rest on both.
using Vec3 = Eigen::Vector3d;

inline double dot(const Vec3& a, const Vec3& b) { return (a.x() * b.x() + a.y() * b.y()) + a.z() * b.z(); }

inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x()};
}

inline double length(const Vec3& a) { return std::sqrt(dot(a, a)); }

/// Turns −0.0 into +0.0 and keeps every other value. Mirrored motion produces −0.0, whose bits hash differently.
inline double plus_zero(double a) { return a + 0.0; }
inline Vec3 plus_zero(const Vec3& a) { return {a.x() + 0.0, a.y() + 0.0, a.z() + 0.0}; }

/// A column of vectors as three columns of doubles: hashing, logging and lanes read contiguous memory.
struct Vec3Column {
  std::vector<double> x, y, z;

  [[nodiscard]] std::size_t size() const { return x.size(); }
  Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, const Vec3& v) {
    x[i] = v.x();
    y[i] = v.y();
    z[i] = v.z();
  }
  void push_back(const Vec3& v) {
    x.push_back(v.x());
    y.push_back(v.y());
    z.push_back(v.z());
  }
  void insert(std::size_t i, const Vec3& v) {
    x.insert(x.begin() + static_cast<std::ptrdiff_t>(i), v.x());
    y.insert(y.begin() + static_cast<std::ptrdiff_t>(i), v.y());
    z.insert(z.begin() + static_cast<std::ptrdiff_t>(i), v.z());
  }
  void erase(std::size_t i) {
    x.erase(x.begin() + static_cast<std::ptrdiff_t>(i));
    y.erase(y.begin() + static_cast<std::ptrdiff_t>(i));
    z.erase(z.begin() + static_cast<std::ptrdiff_t>(i));
  }
  void resize(std::size_t n) {
    x.resize(n);
    y.resize(n);
    z.resize(n);
  }
  void assign(std::size_t n, const Vec3& v) {
    x.assign(n, v.x());
    y.assign(n, v.y());
    z.assign(n, v.z());
  }
  void clear() {
    x.clear();
    y.clear();
    z.clear();
  }
  friend bool operator==(const Vec3Column&, const Vec3Column&) = default;
};

}  // namespace tumble::sim
