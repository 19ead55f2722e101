#include "replay/measure/measure_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "replay/format/not_finite.h"
#include "src/base/check.h"

namespace tumble::replay {
namespace {

using sim::BoxFrame;
using sim::Vec3;

// Edges with |edge × edge|² below this count as parallel: a face axis measures the same there. Just above it, rounding
// turns the axis by about 1e-16 / 1e-6, far less than any overlap of interest.
constexpr double kParallelSquared = 1e-12;

double reach(const BoxFrame& box, const Vec3& axis) {
  return (box.half_extent.x() * std::fabs(sim::dot(box.axes[0], axis)) +
          box.half_extent.y() * std::fabs(sim::dot(box.axes[1], axis))) +
         box.half_extent.z() * std::fabs(sim::dot(box.axes[2], axis));
}

// The distance between the projections on an axis of unit length, negative when they overlap.
double distance_along(const BoxFrame& a, const BoxFrame& b, const Vec3& axis) {
  return std::fabs(sim::dot(b.position - a.position, axis)) - (reach(a, axis) + reach(b, axis));
}

struct Interval {
  double low;
  double high;
};
using Extents = std::array<Interval, 3>;

Extents extents_of(const BoxFrame& box) {
  Extents extents{};
  for (int k = 0; k < 3; ++k) {
    const double r = sim::reach_along(box, k);
    extents[static_cast<std::size_t>(k)] = {box.position[k] - r, box.position[k] + r};
  }
  return extents;
}

bool finite(const Extents& extents) {
  return std::ranges::all_of(extents, [](const Interval& along) { return std::isfinite(along.high - along.low); });
}

// An upper bound of the overlap: the least overlap of the AABBs along the world's axes, negative when they are apart.
double most_depth(const Extents& a, const Extents& b) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    least = std::min(least, std::min(a[k].high, b[k].high) - std::max(a[k].low, b[k].low));
  }
  return least;
}

// The axis along which the centres vary most.
std::size_t widest_axis(std::span<const BoxFrame> boxes) {
  Vec3 sum = Vec3::Zero(), squares = Vec3::Zero();
  for (const BoxFrame& box : boxes) {
    sum += box.position;
    squares += box.position.cwiseProduct(box.position);
  }
  const Vec3 variance = squares - sum.cwiseProduct(sum) / static_cast<double>(boxes.size());
  if (variance.x() >= variance.y() && variance.x() >= variance.z()) return 0;
  return variance.y() >= variance.z() ? 1 : 2;
}

double along_faces(const BoxFrame& a, const BoxFrame& b) {
  double distance = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    distance = largest(largest(distance, distance_along(a, b, a.axes[i])), distance_along(a, b, b.axes[i]));
  }
  return distance;
}

// The larger of `distance` and the distances along the edges' cross products.
double along_edges(const BoxFrame& a, const BoxFrame& b, double distance) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vec3 edge = sim::cross(a.axes[i], b.axes[j]);
      const double squared = sim::dot(edge, edge);
      if (squared >= kParallelSquared) distance = largest(distance, distance_along(a, b, edge / std::sqrt(squared)));
    }
  }
  return distance;
}

}  // namespace

// Two convex polyhedra are apart exactly if a plane separates them that is normal to a face of one or to an edge of
// each (Gottschalk, Lin, Manocha 1996, section 5). For two boxes that makes 3 + 3 + 9 axes. If the projections overlap
// on all of them, the axis of the least overlap is the shortest way apart.
double separation_of(const BoxFrame& a, const BoxFrame& b) { return along_edges(a, b, along_faces(a, b)); }

// The nine edge axes are tried only if the six face axes leave a depth to shorten.
double overlap_depth(const BoxFrame& a, const BoxFrame& b) {
  const double faces = along_faces(a, b);
  return largest(0.0, -(faces < 0 ? along_edges(a, b, faces) : faces));
}

// A sweep along the widest axis: sorted by their low end, only boxes whose intervals overlap by more than the deepest
// overlap so far can change the result. The bound grows with the search, so a crowd in which each box meets each costs
// few exact tests.
double deepest_overlap(std::span<const BoxFrame> boxes, std::span<const std::uint8_t> left_out) {
  SIM_CHECK(boxes.size() == left_out.size(), boxes.size(), left_out.size());
  if (boxes.size() < 2) return 0;
  const std::size_t axis = widest_axis(boxes);
  std::vector<Extents> extents;
  extents.reserve(boxes.size());
  for (const BoxFrame& box : boxes) {
    extents.push_back(extents_of(box));
    if (!finite(extents.back())) return kNotANumber;  // NaN has no place in an order
  }
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return extents[i][axis].low; });

  double deepest = 0;
  for (std::size_t first = 0; first < order.size(); ++first) {
    const std::size_t i = order[first];
    for (std::size_t second = first + 1; second < order.size(); ++second) {
      const std::size_t j = order[second];
      if (extents[i][axis].high - extents[j][axis].low <= deepest) break;
      if ((left_out[i] != 0 && left_out[j] != 0) || most_depth(extents[i], extents[j]) <= deepest) continue;
      deepest = largest(deepest, overlap_depth(boxes[i], boxes[j]));
    }
  }
  return deepest;
}

double ground_penetration(const BoxFrame& box) { return largest(0.0, sim::reach_along(box, 2) - box.position.z()); }

}  // namespace tumble::replay
