#pragma once

// Collision points on the ground for any number of lanes: the operations of ground_contact in
// src/thesis/find_contacts.cc, in their order. lane_vector.h says who may include this.

#include "src/kernels/body_kernels_impl.h"
#include "src/kernels/ground_contacts.h"
#include "src/kernels/lanes/lane_rows.h"
#include "src/kernels/lanes/lane_vector.h"
#include "src/math/grid_magic.h"

namespace tumble::sim {
namespace {

// A box with its axes, as rows of BoxFrame hold it.
template <class V>
struct LaneFrame {
  Space<V> position, axes[3], half;

  LaneFrame(const double* frames, const std::uint32_t* row) {
    V c[16];
    constexpr unsigned kFirst[] = {0, 4, 8, 11};  // the last four overlap the four before
    for (const unsigned first : kFirst) gather4(frames, kFrameDoubles, row, first, c + first);
    position = {c[0], c[1], c[2]};
    for (int k = 0; k < 3; ++k) axes[k] = {c[3 * k + 3], c[3 * k + 4], c[3 * k + 5]};
    half = {c[12], c[13], c[14]};
  }
};

// As corners() for a box at the origin, in its order.
template <class V>
void put_corners(const LaneFrame<V>& box, Space<V> (&all)[8]) {
  const Space<V> x = box.axes[0] * box.half.x, y = box.axes[1] * box.half.y, z = box.axes[2] * box.half.z;
  const Space<V> base[4] = {-x - y, x - y, y - x, x + y};
  for (int k = 0; k < 4; ++k) {
    all[k] = plus_zero(base[k] - z);
    all[k + 4] = plus_zero(base[k] + z);
  }
}

template <class V>
void find_point_at(GroundPoints& points, std::size_t at) {
  const LaneFrame<V> box(points.frames, points.body + at);
  Space<V> corners[8];
  put_corners(box, corners);
  const V zero = V{} + 0.0, height = box.position.z;
  V depth[8], deepest = zero;
  for (int k = 0; k < 8; ++k) {
    depth[k] = -height - corners[k].z;
    deepest = larger(deepest, depth[k]);
  }
  Space<V> sum = {zero, zero, zero};
  V weights = zero, behind = zero;
  double bit = 1;
  for (int k = 0; k < 8; ++k, bit *= 2) {
    const auto lies_behind = depth[k] > 0.0;
    const V weight = on_grid(depth[k] / deepest, kUnitMagic);
    const Space<V> part = on_grid(corners[k] * weight, kPlaceMagic);
    sum = sum + chosen(lies_behind, part, {zero, zero, zero});
    weights = weights + (lies_behind ? weight : zero);
    behind = behind + (lies_behind ? V{} + bit : zero);
  }
  const Space<V> point = on_grid(Space<V>{sum.x / weights, sum.y / weights, sum.z / weights}, kPlaceMagic);
  const V reach = (box.half.x * absolute(box.axes[0].z) + box.half.y * absolute(box.axes[1].z)) +
                  box.half.z * absolute(box.axes[2].z);
  store(points.depth + at, reach - height);
  store(points.behind + at, behind);
  const V of_point[3] = {point.x, point.y, point.z};
  for (int axis = 0; axis < 3; ++axis) store(points.point[axis] + at, of_point[axis]);
  for (int k = 0; k < 8; ++k) {
    const Space<V> from_point = corners[k] - point;
    store(points.corner[k][0] + at, from_point.x);
    store(points.corner[k][1] + at, from_point.y);
    store(points.corner[k][2] + at, from_point.z);
  }
}

template <int kWidth>
[[gnu::flatten]] void find_ground_points(GroundPoints& points) {
  for_rows<kWidth>({0, points.count}, [&](auto v, std::size_t at) { find_point_at<decltype(v)>(points, at); });
}

}  // namespace
}  // namespace tumble::sim
