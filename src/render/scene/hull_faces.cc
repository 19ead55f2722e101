#include "src/render/scene/hull_faces.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace tumble::render {
namespace {

using sim::Vec3;

constexpr double kFlat = 1e-9;  // of the size of the hull

class Hull {
 public:
  explicit Hull(std::span<const Vec3> points) : points_(points) {
    for (const Vec3& point : points_) {
      for (int k = 0; k < 3; ++k) size_ = std::max(size_, std::fabs(point[k] - points_[0][k]));
    }
  }

  /// Four points that span a volume: each the farthest from what is there. False: there are none.
  bool begin() {
    const Vec3 first = points_[0];
    const std::size_t a = farthest([&](const Vec3& p) { return sim::length(p - first); });
    const Vec3 along = points_[a] - first;
    if (!(sim::length(along) > kFlat * size_)) return false;
    const std::size_t b = farthest([&](const Vec3& p) { return sim::length(sim::cross(p - first, along)); });
    const Vec3 normal = sim::cross(along, points_[b] - first);
    if (!(sim::length(normal) > kFlat * size_ * size_)) return false;
    const std::size_t c = farthest([&](const Vec3& p) { return std::fabs(sim::dot(p - first, normal)); });
    const double side = sim::dot(points_[c] - first, normal);
    if (!(std::fabs(side) > kFlat * size_ * size_ * size_)) return false;
    const auto i = static_cast<std::uint32_t>(a), j = static_cast<std::uint32_t>(b), k = static_cast<std::uint32_t>(c);
    if (side > 0) {
      faces_ = {{0, j, i}, {0, i, k}, {i, j, k}, {j, 0, k}};
    } else {
      faces_ = {{0, i, j}, {i, 0, k}, {j, i, k}, {0, j, k}};
    }
    return true;
  }

  /// Replaces the faces that point `p` sees.
  void add(std::uint32_t p) {
    const auto hidden =
        std::partition(faces_.begin(), faces_.end(), [&](const HullFace& face) { return !sees(p, face); });
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (auto face = hidden; face != faces_.end(); ++face) {
      for (std::size_t k = 0; k < 3; ++k) edges.emplace((*face)[k], (*face)[(k + 1) % 3]);
    }
    faces_.erase(hidden, faces_.end());
    for (const auto& [from, to] : edges) {
      if (!edges.contains({to, from})) faces_.push_back({from, to, p});  // the rim
    }
  }

  [[nodiscard]] const std::vector<HullFace>& faces() const { return faces_; }

 private:
  template <class Measure>
  std::size_t farthest(const Measure& measure) const {
    return static_cast<std::size_t>(std::ranges::max_element(points_, {}, measure) - points_.begin());
  }

  [[nodiscard]] bool sees(std::uint32_t p, const HullFace& face) const {
    const Vec3& a = points_[face[0]];
    const Vec3 normal = sim::cross(points_[face[1]] - a, points_[face[2]] - a);
    return sim::dot(points_[p] - a, normal) > kFlat * size_ * sim::length(normal);
  }

  std::span<const Vec3> points_;
  double size_ = 0;
  std::vector<HullFace> faces_;
};

}  // namespace

std::vector<HullFace> hull_faces(std::span<const Vec3> points) {
  if (points.size() < 4) return {};
  Hull hull(points);
  if (!hull.begin()) return {};
  for (std::uint32_t p = 1; p < points.size(); ++p) hull.add(p);
  return hull.faces();
}

}  // namespace tumble::render
