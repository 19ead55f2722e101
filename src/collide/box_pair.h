#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "src/kernels/box_frame.h"
#include "src/kernels/box_tests.h"

namespace tumble::sim {

/// The axes along which two boxes can be separated (Gottschalk 1996): 0–2 the faces of a, 3–5 the faces of b, and
/// 6 + 3i + j the edge i of a crossed with the edge j of b. A set of them is a bit mask, as in PairTable::planes.
inline constexpr int kAxisCount = 15;
using AxisSet = std::uint16_t;
inline constexpr AxisSet kFacesOfA = 0b111;
inline constexpr AxisSet kFacesOfB = 0b111000;
inline constexpr AxisSet kFaces = kFacesOfA | kFacesOfB;
inline constexpr AxisSet kEdges = 0b111111111000000;
constexpr AxisSet only(int axis) { return static_cast<AxisSet>(1U << static_cast<unsigned>(axis)); }

/// The best axes of a set: those with the largest separation, all of them on an exact tie. `axes` is 0 when no axis of
/// the set has a direction.
struct BestAxes {
  AxisSet axes = 0;
  double separation = 0;  ///< m, negative when the boxes overlap along the axis
};

/// A result of pair k of the test in lanes.
inline BestAxes best_of(const BoxTests::Best& best, std::size_t k) {
  return {static_cast<AxisSet>(best.axes[k]), best.separation[k]};
}

/// The larger separation of two results; a result without axes does not count.
inline double larger_separation(const BestAxes& x, const BestAxes& y) {
  if (x.axes == 0) return y.separation;
  if (y.axes == 0) return x.separation;
  return std::max(x.separation, y.separation);
}

/// Two boxes and the products of their axes that every separation needs. Every result follows from d = x_b − x_a, which
/// is exact on the position grid, so a shift of the pair changes no bit. Sums are arranged so that exchanging a and b,
/// mirroring, and swapping x and y change no bit either.
///
/// An axis has no direction, and is skipped, in two cases. First, d has no part along the axis: either sign would be an
/// arbitrary choice. Second, the axis is the cross product of edges that are nearly parallel to each other or to a face
/// normal: such an axis repeats a face, and an edge contact in its place would put the collision on one arbitrary edge
/// (the lateral error of the thesis's Fig. 22).
class BoxPair {
 public:
  BoxPair(const BoxFrame& a, const BoxFrame& b) : BoxPair(a, b, b.position - a.position) {}
  /// With b at `offset` (m, world axes) from a, whatever positions the frames have.
  BoxPair(const BoxFrame& a, const BoxFrame& b, const Vec3& offset);

  /// The axes of `candidates` along which the boxes are apart or just touch.
  [[nodiscard]] AxisSet separating(AxisSet candidates) const;

  /// Whether one of the edge axes that repeat a face separates the boxes. Such an axis is no plane to collide on, but
  /// boxes that it separates do not touch: without this test crossed bars would collide at a distance.
  [[nodiscard]] bool apart_along_facelike_edges() const;

  /// The largest separation among `candidates`.
  [[nodiscard]] BestAxes best(AxisSet candidates) const;

  /// The second largest separation among three candidates, m; −∞ where fewer than two have a direction.
  [[nodiscard]] double second(AxisSet candidates) const;

  /// The largest separation among all fifteen axes, edge axes that repeat a face included: positive where the boxes do
  /// not touch, whatever keeps them apart.
  [[nodiscard]] BestAxes best_of_all() const;

  /// The direction of an axis, unit length, from a to b. Precondition: the axis has a direction.
  [[nodiscard]] Vec3 normal(int axis) const;

  [[nodiscard]] const BoxFrame& a() const { return *a_; }
  [[nodiscard]] const BoxFrame& b() const { return *b_; }
  /// x_b − x_a, m, world axes.
  [[nodiscard]] const Vec3& offset() const { return offset_; }

 private:
  using Separation = std::optional<double>;  // m; nothing along an axis without direction
  // a's edge i crossed with b's edge j.
  struct Edges {
    int i, j;
    Vec3 axis;
    double squared, length;
    Edges(int edge_a, int edge_b, const BoxFrame& a, const BoxFrame& b)
        : i(edge_a),
          j(edge_b),
          axis(cross(a.axes[i], b.axes[j])),
          squared(dot(axis, axis)),
          length(std::sqrt(squared)) {}
  };
  [[nodiscard]] Separation along(int axis) const;
  [[nodiscard]] Separation along_edge(const Edges& edges,
                                      double least_squared) const;  // a value even where the axis repeats a face
  [[nodiscard]] bool facelike(const Edges& edges) const;
  static void better(int axis, const Separation& s, BestAxes& best);

  const BoxFrame* a_;
  const BoxFrame* b_;
  Vec3 offset_;
  double product_[3][3];  // |a's axis i · b's axis j|
  double offset_a_[3];    // offset · a's axis i
  double offset_b_[3];
};

/// BoxPair(a, b, offset).normal(axis), without the other axes.
Vec3 normal_along(const BoxFrame& a, const BoxFrame& b, const Vec3& offset, int axis);

/// BoxPair(a, b).separating(candidates); faster where the candidates are faces.
AxisSet separating(const BoxFrame& a, const BoxFrame& b, AxisSet candidates);

}  // namespace tumble::sim
