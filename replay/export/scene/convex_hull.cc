#include "replay/export/scene/convex_hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace tumble::replay {
namespace {

using sim::Vec3;

constexpr double kOnFace = 1e-9;  // of the extent

class Hull {
 public:
  explicit Hull(const std::vector<Vec3>& points) : points_(points) {}

  std::vector<std::uint32_t> triangles() {
    if (!begin()) return {};
    for (std::uint32_t p = 0; p < points_.size(); ++p) add(p);
    std::vector<std::uint32_t> all;
    for (const Face& face : faces_) all.insert(all.end(), face.corners.begin(), face.corners.end());
    return all;
  }

 private:
  struct Face {
    std::array<std::uint32_t, 3> corners;
    Vec3 normal;
    double offset;
  };

  [[nodiscard]] double above(const Face& face, std::uint32_t p) const {
    return sim::dot(face.normal, points_[p]) - face.offset;
  }

  void push(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    Vec3 normal = sim::cross(points_[b] - points_[a], points_[c] - points_[a]);
    const double length = sim::length(normal);
    if (length > 0) normal /= length;
    faces_.push_back({{a, b, c}, normal, sim::dot(normal, points_[a])});
  }

  /// The index that `measure` is largest for.
  template <class Measure>
  std::uint32_t farthest(Measure measure) const {
    std::uint32_t best = 0;
    for (std::uint32_t p = 1; p < points_.size(); ++p) {
      if (measure(p) > measure(best)) best = p;
    }
    return best;
  }

  /// A tetrahedron of four points that are far apart.
  bool begin() {
    if (points_.size() < 4) return false;
    const std::uint32_t a = farthest([&](std::uint32_t p) { return -points_[p].x(); });
    const std::uint32_t b = farthest([&](std::uint32_t p) { return sim::length(points_[p] - points_[a]); });
    const Vec3 line = points_[b] - points_[a];
    extent_ = sim::length(line);
    const std::uint32_t c =
        farthest([&](std::uint32_t p) { return sim::length(sim::cross(line, points_[p] - points_[a])); });
    Vec3 normal = sim::cross(line, points_[c] - points_[a]);
    const double area = sim::length(normal);
    if (!(area > kOnFace * extent_ * extent_)) return false;
    normal /= area;
    const std::uint32_t d =
        farthest([&](std::uint32_t p) { return std::fabs(sim::dot(normal, points_[p] - points_[a])); });
    const double height = sim::dot(normal, points_[d] - points_[a]);
    if (!(std::fabs(height) > kOnFace * extent_)) return false;
    const std::uint32_t second = height > 0 ? c : b, third = height > 0 ? b : c;
    push(a, second, third);
    push(a, third, d);
    push(third, second, d);
    push(second, a, d);
    return true;
  }

  /// Replaces the faces that the point sees by a cone from their edge to the point.
  void add(std::uint32_t p) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    std::vector<Face> kept;
    for (const Face& face : faces_) {
      if (!(above(face, p) > kOnFace * extent_)) {
        kept.push_back(face);
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) edges.emplace(face.corners[k], face.corners[(k + 1) % 3]);
    }
    if (edges.empty()) return;
    faces_ = std::move(kept);
    for (const auto& [from, to] : edges) {
      if (!edges.contains({to, from})) push(from, to, p);
    }
  }

  const std::vector<Vec3>& points_;
  std::vector<Face> faces_;
  double extent_ = 0;
};

}  // namespace

std::vector<std::uint32_t> convex_hull(const std::vector<sim::Vec3>& points) { return Hull(points).triangles(); }

}  // namespace tumble::replay
