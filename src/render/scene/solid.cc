#include "src/render/scene/solid.h"

#include <array>
#include <cmath>

#include "src/render/scene/hull_faces.h"

namespace tumble::render {
namespace {

using sim::Vec3;

constexpr double kPi = 3.14159265358979323846;

struct Direction {
  double cosine = 1, sine = 0;
};

/// Directions around a circle, the first one again at the end.
std::array<Direction, kSolidParts + 1> circle() {
  // The cosine and sine of an eighth of a right angle's third: 2 pi / 48, by halving 30 degrees twice.
  double cosine = std::sqrt(3.0) / 2;
  for (int k = 0; k < 2; ++k) cosine = std::sqrt((1 + cosine) / 2);
  const double sine = std::sqrt(1 - cosine * cosine);
  std::array<Direction, kSolidParts + 1> all{};
  for (int k = 1; k < kSolidParts; ++k) {
    const Direction& last = all[static_cast<std::size_t>(k - 1)];
    all[static_cast<std::size_t>(k)] = {last.cosine * cosine - last.sine * sine,
                                        last.sine * cosine + last.cosine * sine};
  }
  return all;
}

void store(float (&to)[3], const Vec3& from) {
  for (int k = 0; k < 3; ++k) to[k] = static_cast<float>(from[k]);
}

/// Along `axis`, with `x` and `y` across, as a right-handed triple.
Vec3 placed(int axis, double x, double y, double along) {
  if (axis == 0) return {along, x, y};
  if (axis == 1) return {y, along, x};
  return {x, y, along};
}

/// A point of a surface of revolution: its radius and height, and the normal's.
struct Ring {
  double radius = 0, height = 0;
  double normal_radius = 1, normal_height = 0;
  double place = 0;  // m along the profile
};

class Revolved {
 public:
  Revolved(int axis, double widest) : axis_(axis), widest_(widest), circle_(circle()) {}

  /// The band between two rings, the lower one first.
  void add(const Ring& low, const Ring& high) {
    for (std::size_t k = 0; k < kSolidParts; ++k) {
      const SolidVertex a = corner(low, k), b = corner(low, k + 1), c = corner(high, k + 1), d = corner(high, k);
      if (low.radius > 0) solid_.corners.insert(solid_.corners.end(), {a, b, c});
      if (high.radius > 0) solid_.corners.insert(solid_.corners.end(), {a, c, d});
    }
  }
  Solid take() { return std::move(solid_); }

 private:
  [[nodiscard]] SolidVertex corner(const Ring& ring, std::size_t k) const {
    const Direction& d = circle_[k];
    SolidVertex vertex{};
    store(vertex.at, placed(axis_, ring.radius * d.cosine, ring.radius * d.sine, ring.height));
    store(vertex.normal, placed(axis_, ring.normal_radius * d.cosine, ring.normal_radius * d.sine, ring.normal_height));
    vertex.place[0] = static_cast<float>(2 * kPi * widest_ * static_cast<double>(k) / kSolidParts);
    vertex.place[1] = static_cast<float>(ring.place);
    return vertex;
  }

  int axis_;
  double widest_;
  std::array<Direction, kSolidParts + 1> circle_;
  Solid solid_;
};

/// A flat face, with the two axes across its normal as places on it.
void add_face(Solid& solid, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 cross = sim::cross(b - a, c - a);
  const double length = sim::length(cross);
  if (!(length > 0)) return;
  const Vec3 normal = cross / length;
  int widest = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::fabs(normal[k]) > std::fabs(normal[widest])) widest = k;
  }
  for (const Vec3& at : {a, b, c}) {
    SolidVertex vertex{};
    store(vertex.at, at);
    store(vertex.normal, normal);
    vertex.place[0] = static_cast<float>(at[(widest + 1) % 3]);
    vertex.place[1] = static_cast<float>(at[(widest + 2) % 3]);
    solid.corners.push_back(vertex);
  }
}

}  // namespace

Solid make_capsule(int axis, double radius, double half_length) {
  constexpr std::size_t kQuarter = kSolidParts / 4;
  const auto around = circle();
  Revolved made(axis, radius);
  std::vector<Ring> rings;
  for (std::size_t k = 0; k <= 2 * kQuarter; ++k) {
    // From the lower pole up: sine and cosine of −90 … 90 degrees. The equator is there twice, around the straight
    // part.
    const Direction& d = around[k <= kQuarter ? kQuarter - k : k - kQuarter];
    const bool pole = k == 0 || k == 2 * kQuarter;
    const double across = pole ? 0 : d.cosine, up = pole ? 1 : d.sine, side = k < kQuarter ? -1 : 1;
    Ring ring = {radius * across, side * (radius * up + half_length), across, side * up,
                 radius * kPi / 2 * static_cast<double>(k) / kQuarter};
    if (k > kQuarter) ring.place += 2 * half_length;
    if (k == kQuarter) {
      ring.height = -half_length;
      rings.push_back(ring);
      ring.height = half_length;
      ring.place += 2 * half_length;
    }
    rings.push_back(ring);
  }
  for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
    if (rings[k].height < rings[k + 1].height) made.add(rings[k], rings[k + 1]);
  }
  return made.take();
}

Solid make_cylinder(int axis, double radius, double half_length) {
  Revolved made(axis, radius);
  const double length = 2 * half_length;
  made.add({0, -half_length, 0, -1, 0}, {radius, -half_length, 0, -1, radius});
  made.add({radius, -half_length, 1, 0, radius}, {radius, half_length, 1, 0, radius + length});
  made.add({radius, half_length, 0, 1, radius + length}, {0, half_length, 0, 1, 2 * radius + length});
  return made.take();
}

Solid make_hull(std::span<const Vec3> points) {
  Solid solid;
  for (const auto& [a, b, c] : hull_faces(points)) add_face(solid, points[a], points[b], points[c]);
  return solid;
}

Solid make_mesh(std::span<const Vec3> points, std::span<const std::uint32_t> triangles) {
  Solid solid;
  for (std::size_t k = 0; k + 2 < triangles.size(); k += 3) {
    const Vec3 &a = points[triangles[k]], &b = points[triangles[k + 1]], &c = points[triangles[k + 2]];
    add_face(solid, a, b, c);
    add_face(solid, c, b, a);
  }
  return solid;
}

}  // namespace tumble::render
