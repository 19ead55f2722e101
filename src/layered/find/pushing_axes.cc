#include "src/layered/find/pushing_axes.h"

#include <algorithm>
#include <cmath>

namespace tumble::sim {
namespace {

struct OpenAxis {
  int axis;
  Vec3 n;
  double open;     // m until it closes
  double closing;  // m by which the motion closes it, at most
};

// How far turning brings a corner of the box along n, m, at most.
double turned_along(const BoxFrame& box, const Vec3& turn, const Vec3& n) {
  const Vec3 c = cross(n, turn), &h = box.half_extent;
  const auto reach = [&](int k) { return h[k] * std::fabs(dot(box.axes[k], c)); };
  return ((reach(0) + reach(1)) + reach(2)) + 0.5 * (length(turn) * (length(c) * length(h)));
}

class OpenAxes {
 public:
  OpenAxes(const BoxPair& boxes, const OpenOverlap& overlap) {
    for (int axis = 0; axis < kAxisCount; ++axis) {
      const BestAxes now = boxes.best(only(axis));
      if (now.axes == 0 || now.separation < -overlap.most) continue;
      const double open = std::min(now.separation + overlap.most, std::max(now.separation, 0.0) + overlap.resting);
      axes_[count_++] = {axis, boxes.normal(axis), open, 0};
    }
  }

  void move(const BoxPair& boxes, const PairMotion& motion) {
    for (OpenAxis* k = axes_; k < axes_ + count_; ++k) {
      const double turned = turned_along(boxes.a(), motion.turn_a, k->n) + turned_along(boxes.b(), motion.turn_b, k->n);
      k->closing = turned - dot(motion.way, k->n);
    }
  }

  // Whether two of those that satisfy `counts` are two directions.
  template <class Counts>
  [[nodiscard]] bool two_directions(Counts counts) const {
    for (const OpenAxis* k = axes_; k < axes_ + count_; ++k) {
      for (const OpenAxis* l = axes_; l < k; ++l)
        if (counts(*k) && counts(*l) && other_direction(*k, *l)) return true;
    }
    return false;
  }

  [[nodiscard]] AxisSet staying() const {
    AxisSet set = 0;
    for (const OpenAxis* k = axes_; k < axes_ + count_; ++k) set |= stays(*k) ? only(k->axis) : AxisSet{0};
    return set;
  }
  static bool stays(const OpenAxis& k) { return k.closing <= k.open; }

  // Those in the directions that close last. Precondition: all close.
  [[nodiscard]] AxisSet last() const {
    double latest = 0;  // part of the motion
    for (const OpenAxis* k = axes_; k < axes_ + count_; ++k) latest = std::max(latest, k->open / k->closing);
    AxisSet set = 0;
    for (const OpenAxis* k = axes_; k < axes_ + count_; ++k) {
      if (k->open / k->closing != latest) continue;
      for (const OpenAxis* l = axes_; l < axes_ + count_; ++l)
        set |= other_direction(*k, *l) ? AxisSet{0} : only(l->axis);
    }
    return set;
  }

 private:
  static bool other_direction(const OpenAxis& k, const OpenAxis& l) {
    return std::fabs(dot(k.n, l.n)) < kOtherDirection;
  }

  OpenAxis axes_[kAxisCount];
  std::size_t count_ = 0;
};

}  // namespace

PushingAxes pushing_axes(const BoxPair& boxes, const PairMotion& motion, const OpenOverlap& overlap) {
  OpenAxes open(boxes, overlap);
  if (!open.two_directions([](const OpenAxis&) { return true; })) return {};
  open.move(boxes, motion);
  const AxisSet staying = open.staying();
  if (staying == 0) return {false, false, open.last()};
  if (open.two_directions(OpenAxes::stays)) return {false, true, 0};
  return {false, true, staying};
}

}  // namespace tumble::sim
