#include "src/layered/find/contact_axes.h"

#include <algorithm>
#include <cmath>

#include "src/layered/find/manifold_points.h"

namespace tumble::sim {

double separation_of(const TestedPair& pair) {
  const double face = larger_separation(pair.face_a, pair.face_b);
  return pair.edge.axes != 0 ? std::max(face, pair.edge.separation) : face;
}

bool may_open_two(const BoxFrame& a, const BoxFrame& b, const TestedPair& pair, double overlap) {
  if (std::max(pair.second_a, pair.second_b) >= -overlap) return true;
  if (pair.edge.axes != 0 && pair.edge.separation >= -overlap) return true;
  if (pair.face_a.axes == 0 || pair.face_b.axes == 0) return false;
  if (std::min(pair.face_a.separation, pair.face_b.separation) < -overlap) return false;
  const int of_a = std::countr_zero(pair.face_a.axes), of_b = std::countr_zero(pair.face_b.axes) - 3;
  return std::fabs(dot(a.axes[of_a], b.axes[of_b])) < kOtherDirection;
}

int reference_order(const BoxFrame& box_a, const BoxFrame& box_b, const Vec3& offset) {
  const double a = volume_measure(box_a), b = volume_measure(box_b);
  if (a != b) return a > b ? 1 : -1;
  const double up = offset.z();
  return up > 0 ? 1 : up < 0 ? -1 : 0;
}

ContactAxes preferred_axes(const TestedPair& pair, int order, double smallest) {
  const BestAxes &a = pair.face_a, &b = pair.face_b, &edge = pair.edge;
  const double face = larger_separation(a, b), prefer = kFacePreference * smallest;
  const bool no_face = a.axes == 0 && b.axes == 0;
  if (edge.axes != 0 && (no_face || edge.separation > face + kEdgePreference * smallest)) return {0, 0, edge};
  // One that has none left does not count.
  const bool a_first = order >= 0 || b.axes == 0, b_first = order <= 0 || a.axes == 0;
  const bool on_a = a_first ? a.separation >= face - prefer : a.separation > b.separation + prefer;
  const bool on_b = b_first ? b.separation >= face - prefer : b.separation > a.separation + prefer;
  return {on_a ? a.axes : AxisSet{0}, on_b ? static_cast<AxisSet>(b.axes >> 3U) : AxisSet{0}, {}};
}

bool leave_pushing(const BoxFrame& a, const BoxFrame& b, const PairMotion& motion, const OpenOverlap& overlap,
                   TestedPair& pair) {
  const BoxPair boxes(a, b, pair.offset);
  const PushingAxes pushing = pushing_axes(boxes, motion, overlap);
  if (pushing.all) return false;
  const auto best = [&](AxisSet of) { return boxes.best(static_cast<AxisSet>(pushing.axes & of)); };
  pair.face_a = best(kFacesOfA);
  pair.face_b = best(kFacesOfB);
  pair.edge = best(kEdges);
  return pushing.passing;
}

BestAxes last_axes(const BoxPair& boxes) {
  BestAxes last = boxes.best_of_all();
  for_each_axis(static_cast<AxisSet>(last.axes & kEdges), [&](int axis) {
    const Vec3 n = boxes.normal(axis);
    if (!one_farthest_edge(boxes.a(), (axis - 6) / 3, n) || !one_farthest_edge(boxes.b(), (axis - 6) % 3, n))
      last.axes = static_cast<AxisSet>(last.axes & ~only(axis));
  });
  return last;
}

}  // namespace tumble::sim
