#include "src/collide/box_pair.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "src/base/check.h"
#include "src/kernels/box_tests.h"

namespace tumble::sim {
namespace {

constexpr int kNext[3] = {1, 2, 0};
constexpr int kAfterNext[3] = {2, 0, 1};

// m, of a part of the offset along a face's normal.
std::optional<double> separation_of(double along, double reach) {
  if (along == 0) return {};
  return std::fabs(along) - reach;
}

// BoxPair::along for one face of `box`, without the products of the other axes.
bool apart_along_face(const BoxFrame& box, int face, const BoxFrame& other, const Vec3& offset) {
  const Vec3 &normal = box.axes[face], &h = other.half_extent;
  const double distance = dot(offset, normal);
  const auto along = [&](int k) { return std::fabs(dot(normal, other.axes[k])); };
  const double reach = box.half_extent[face] + ((h.x() * along(0) + h.y() * along(1)) + h.z() * along(2));
  const std::optional<double> separation = separation_of(distance, reach);
  return separation && *separation >= 0;
}

}  // namespace

AxisSet separating(const BoxFrame& a, const BoxFrame& b, AxisSet candidates) {
  if ((candidates & kEdges) != 0) return BoxPair(a, b).separating(candidates);
  const Vec3 offset = b.position - a.position;
  AxisSet apart = 0;
  for (unsigned left = candidates; left != 0; left &= left - 1) {
    const int axis = std::countr_zero(left);
    const bool found = axis < 3 ? apart_along_face(a, axis, b, offset) : apart_along_face(b, axis - 3, a, offset);
    if (found) apart |= only(axis);
  }
  return apart;
}

BoxPair::BoxPair(const BoxFrame& a, const BoxFrame& b, const Vec3& offset) : a_(&a), b_(&b), offset_(offset) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) product_[i][j] = std::fabs(dot(a.axes[i], b.axes[j]));
    offset_a_[i] = dot(offset_, a.axes[i]);
    offset_b_[i] = dot(offset_, b.axes[i]);
  }
}

BoxPair::Separation BoxPair::along(int axis) const {
  const Vec3& ha = a_->half_extent;
  const Vec3& hb = b_->half_extent;
  if (axis < 3) {
    const double* p = product_[axis];
    const double reach = ha[axis] + ((hb.x() * p[0] + hb.y() * p[1]) + hb.z() * p[2]);
    return separation_of(offset_a_[axis], reach);
  }
  if (axis < 6) {
    const int j = axis - 3;
    const double reach = hb[j] + ((ha.x() * product_[0][j] + ha.y() * product_[1][j]) + ha.z() * product_[2][j]);
    return separation_of(offset_b_[j], reach);
  }
  const Edges edges((axis - 6) / 3, (axis - 6) % 3, *a_, *b_);
  if (facelike(edges)) return {};
  return along_edge(edges, kParallelSquared);
}

bool BoxPair::facelike(const Edges& edges) const {
  const int i = edges.i, j = edges.j;
  const double limit = kFaceLike * edges.length;
  return product_[kNext[i]][j] > limit || product_[kAfterNext[i]][j] > limit || product_[i][kNext[j]] > limit ||
         product_[i][kAfterNext[j]] > limit;
}

// The reach of each box along the cross product of a's edge i and b's edge j. Both edges are perpendicular to the cross
// product and reach nothing. The cosine of a's axis m to the cross product is that of b's edge to the remaining axis of
// a, divided by the sine between the edges; so the products that the faces need are enough.
BoxPair::Separation BoxPair::along_edge(const Edges& edges, double least_squared) const {
  if (edges.squared < least_squared) return {};
  const int i = edges.i, j = edges.j;
  const double scale = 1 / edges.length;
  const int ia = kNext[i], ib = kAfterNext[i], ja = kNext[j], jb = kAfterNext[j];
  const double along_ia = product_[ib][j] * scale, along_ib = product_[ia][j] * scale;
  const double along_ja = product_[i][jb] * scale, along_jb = product_[i][ja] * scale;
  const double offset = dot(offset_, edges.axis);
  const Vec3& ha = a_->half_extent;
  const Vec3& hb = b_->half_extent;
  const double reach = (ha[ia] * along_ia + ha[ib] * along_ib) + (hb[ja] * along_ja + hb[jb] * along_jb);
  if (offset == 0) return {};
  return std::fabs(offset) * scale - reach;
}

bool BoxPair::apart_along_facelike_edges() const {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Edges edges(i, j, *a_, *b_);
      if (!facelike(edges)) continue;
      const Separation s = along_edge(edges, kParallelSquared);
      if (s && *s >= 0) return true;
    }
  }
  return false;
}

AxisSet BoxPair::separating(AxisSet candidates) const {
  AxisSet apart = 0;
  for (unsigned left = candidates; left != 0; left &= left - 1) {
    const int axis = std::countr_zero(left);
    const Separation s = along(axis);
    if (s && *s >= 0) apart |= only(axis);
  }
  return apart;
}

void BoxPair::better(int axis, const Separation& s, BestAxes& best) {
  if (!s) return;
  if (best.axes == 0 || *s > best.separation) {
    best = {only(axis), *s};
  } else if (*s == best.separation) {
    best.axes |= only(axis);
  }
}

BestAxes BoxPair::best(AxisSet candidates) const {
  BestAxes best;
  for (unsigned left = candidates; left != 0; left &= left - 1) {
    const int axis = std::countr_zero(left);
    better(axis, along(axis), best);
  }
  return best;
}

double BoxPair::second(AxisSet candidates) const {
  double most = -std::numeric_limits<double>::infinity(), second = most;
  for (unsigned left = candidates; left != 0; left &= left - 1) {
    const Separation s = along(std::countr_zero(left));
    if (!s) continue;
    second = std::max(second, std::min(most, *s));
    most = std::max(most, *s);
  }
  return second;
}

BestAxes BoxPair::best_of_all() const {
  BestAxes best = this->best(kFaces);
  for (int axis = 6; axis < kAxisCount; ++axis) {
    better(axis, along_edge(Edges((axis - 6) / 3, (axis - 6) % 3, *a_, *b_), kHardlyParallelSquared), best);
  }
  return best;
}

Vec3 BoxPair::normal(int axis) const {
  SIM_DCHECK(axis >= 6 || along(axis).has_value(), axis);
  return normal_along(*a_, *b_, offset_, axis);
}

Vec3 normal_along(const BoxFrame& a, const BoxFrame& b, const Vec3& offset, int axis) {
  if (axis < 6) {
    const Vec3& normal = axis < 3 ? a.axes[axis] : b.axes[axis - 3];
    return dot(offset, normal) < 0 ? Vec3(-normal) : normal;
  }
  const Vec3 edge = cross(a.axes[(axis - 6) / 3], b.axes[(axis - 6) % 3]);
  const double scale = 1 / std::sqrt(dot(edge, edge));
  return edge * (dot(offset, edge) < 0 ? -scale : scale);
}

// The box test in lanes, of one lane.
namespace {

BoxPair pair_of(const BoxTests& tests, std::size_t k) {
  const Vec3 offset(tests.offset[0][k], tests.offset[1][k], tests.offset[2][k]);
  return {tests.frames[tests.a[k]], tests.frames[tests.b[k]], offset};
}

void put(BoxTests::Best& to, std::size_t k, const BestAxes& best) {
  to.axes[k] = best.axes;
  to.separation[k] = best.separation;
}

}  // namespace

void find_faces_singly(BoxTests& tests) {
  for (std::size_t k = 0; k < tests.count; ++k) {
    const BoxPair pair = pair_of(tests, k);
    put(tests.faces_of_a, k, pair.best(kFacesOfA));
    put(tests.faces_of_b, k, pair.best(kFacesOfB));
    tests.second_of_a[k] = pair.second(kFacesOfA);
    tests.second_of_b[k] = pair.second(kFacesOfB);
  }
}

void find_edges_singly(BoxTests& tests) {
  for (std::size_t k = 0; k < tests.count; ++k) put(tests.edges, k, pair_of(tests, k).best(kEdges));
}

void find_all_singly(BoxTests& tests) {
  find_faces_singly(tests);
  find_edges_singly(tests);
  for (std::size_t k = 0; k < tests.count; ++k) {
    tests.apart_along_facelike[k] = pair_of(tests, k).apart_along_facelike_edges() ? 1 : 0;
  }
}

void find_best_singly(BoxTests& tests) {
  for (std::size_t k = 0; k < tests.count; ++k) put(tests.all, k, pair_of(tests, k).best_of_all());
}

}  // namespace tumble::sim
