#pragma once

#include <bit>

#include "src/layered/find/pair_tests.h"
#include "src/layered/find/pushing_axes.h"

namespace tumble::sim {

/// The largest separation of a pair, m.
double separation_of(const TestedPair& pair);

/// Whether two directions may be open (PushingAxes): a quick no for most pairs that rest on one another.
bool may_open_two(const BoxFrame& a, const BoxFrame& b, const TestedPair& pair, double overlap);

/// Which box of a pair is the reference: > 0: a, < 0: b, 0: each of one manifold, since the two are exactly alike.
/// offset: x_b − x_a, m.
int reference_order(const BoxFrame& a, const BoxFrame& b, const Vec3& offset);

/// The axes of a pair's manifolds.
struct ContactAxes {
  AxisSet faces_of_a = 0, faces_of_b = 0;  ///< each from bit 0 on
  BestAxes edges;
};

/// The axes as resting boxes need them: faces are preferred to edges, and one box's faces to the other's. order: as
/// reference_order; smallest: half extent of both boxes, m.
ContactAxes preferred_axes(const TestedPair& pair, int order, double smallest);

/// Leaves of the axes those that may push (PushingAxes). Returns whether the pair passes.
bool leave_pushing(const BoxFrame& a, const BoxFrame& b, const PairMotion& motion, const OpenOverlap& overlap,
                   TestedPair& pair);

/// The axes that kept two boxes apart until they met, edges that repeat a face included; without edges of which two
/// tie.
BestAxes last_axes(const BoxPair& boxes);

/// The direction of a face's axis that points along the offset.
inline Vec3 towards(const Vec3& offset, const Vec3& axis) { return dot(offset, axis) < 0 ? Vec3(-axis) : axis; }

/// Calls visit(axis) for each axis of the set, in ascending order.
template <class Visit>
void for_each_axis(AxisSet axes, Visit visit) {
  for (unsigned rest = axes; rest != 0; rest &= rest - 1) visit(std::countr_zero(rest));
}

}  // namespace tumble::sim
