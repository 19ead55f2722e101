#pragma once

// What is done to bodies by themselves, for any number of lanes: the operations of free_flight, update_frames and
// reach_out in the same order; see src/math/lane_vector.h for who may include this.

#include "src/math/grid_magic.h"
#include "src/math/lane_rows.h"
#include "src/math/lane_vector.h"
#include "src/world/body_kernels.h"

namespace tumble::sim {
namespace {

constexpr std::size_t kFrameDoubles = 15;  // of a BoxFrame: position, three axes, half extents

template <class V>
constexpr std::size_t kWidthOf = sizeof(V) / sizeof(double);

template <class V>
V round_to(double magic, V x) {
  return ((x + magic) - magic) + 0.0;
}
template <class V>
Space<V> round_to(double magic, Space<V> a) {
  return {round_to(magic, a.x), round_to(magic, a.y), round_to(magic, a.z)};
}
template <class V>
Space<V> plus_zero(Space<V> a) {
  return {a.x + 0.0, a.y + 0.0, a.z + 0.0};
}

template <class V, class Double>
Space<V> load_space(Double* const* columns, std::size_t i) {
  return {load<V>(columns[0] + i), load<V>(columns[1] + i), load<V>(columns[2] + i)};
}
template <class V>
void store_space(double* const* columns, std::size_t i, Space<V> a) {
  store(columns[0] + i, a.x);
  store(columns[1] + i, a.y);
  store(columns[2] + i, a.z);
}

template <class V>
struct LaneQuat {
  V w, x, y, z;
};
template <class V, class Double>
LaneQuat<V> load_quat(Double* const* columns, std::size_t i) {
  return {load<V>(columns[0] + i), load<V>(columns[1] + i), load<V>(columns[2] + i), load<V>(columns[3] + i)};
}

// rotated_by_half of src/math/rotation.h.
template <class V>
LaneQuat<V> rotated_by_half(LaneQuat<V> q, Space<V> h) {
  const V w = q.w - ((h.x * q.x + h.y * q.y) + h.z * q.z), x = (q.x + h.x * q.w) + (h.y * q.z - h.z * q.y);
  const V y = (q.y + h.y * q.w) + (h.z * q.x - h.x * q.z), z = (q.z + h.z * q.w) + (h.x * q.y - h.y * q.x);
  const V n = square_root(w * w + ((x * x + y * y) + z * z));
  return {w / n + 0.0, x / n + 0.0, y / n + 0.0, z / n + 0.0};
}

// axes_of of src/math/rotation.h.
template <class V>
void find_axes(LaneQuat<V> q, Space<V> axes[3]) {
  axes[0] = {1.0 - 2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y + q.w * q.z), 2.0 * (q.x * q.z - q.w * q.y)};
  axes[1] = {2.0 * (q.x * q.y - q.w * q.z), 1.0 - 2.0 * (q.x * q.x + q.z * q.z), 2.0 * (q.y * q.z + q.w * q.x)};
  axes[2] = {2.0 * (q.x * q.z + q.w * q.y), 2.0 * (q.y * q.z - q.w * q.x), 1.0 - 2.0 * (q.x * q.x + q.y * q.y)};
}

// The lanes of bodies that fly and turn alike about every axis: their spin stays.
template <class V>
auto flying(const FlightWork& work, std::size_t i, std::size_t& uneven) {
  V flies;
  for (std::size_t k = 0; k < kWidthOf<V>; ++k) flies[k] = work.flies[i + k];
  const Space<V> inertia = load_space<V>(work.inertia, i);
  const auto even = (inertia.x == inertia.y) & (inertia.y == inertia.z), fly = flies != 0.0;
  for (std::size_t k = 0; k < kWidthOf<V>; ++k) uneven += fly[k] != 0 && even[k] == 0 ? 1U : 0U;
  return fly & even;
}

template <class V, class Mask>
void store_where(Mask where, double* const* columns, std::size_t i, Space<V> now, Space<V> before) {
  store_space<V>(columns, i, {where ? now.x : before.x, where ? now.y : before.y, where ? now.z : before.z});
}

template <class V>
void fly_pack(const FlightWork& work, std::size_t i, std::size_t& uneven) {
  const auto fly = flying<V>(work, i, uneven);
  const Space<V> position = load_space<V>(work.position, i), before = load_space<V>(work.velocity, i);
  const Space<V> spin = load_space<V>(work.spin, i);
  const Space<V> faster = {before.x + work.fall[0], before.y + work.fall[1], before.z + work.fall[2]};
  const bool drag = work.slower > 1;
  const auto slowed = [&](Space<V> a) {
    return round_to(kMotionMagic, Space<V>{a.x / work.slower, a.y / work.slower, a.z / work.slower});
  };
  const Space<V> after = drag ? slowed(faster) : plus_zero(faster);
  const Space<V> path = round_to(kPlaceMagic, (before + after) * (V{} + 0.5 * work.dt_s));
  const LaneQuat<V> q = load_quat<V>(work.orientation, i);
  const LaneQuat<V> turned = rotated_by_half(q, spin * (V{} + 0.5 * work.dt_s));
  store_where(fly, work.position, i, plus_zero(position + path), position);
  store_where(fly, work.velocity, i, after, before);
  if (drag) store_where(fly, work.spin, i, slowed(spin), spin);
  store_where(fly, work.orientation, i, Space<V>{turned.w, turned.x, turned.y}, Space<V>{q.w, q.x, q.y});
  store(work.orientation[3] + i, fly ? turned.z : q.z);
}

template <class V>
void frame_pack(const FrameWork& work, std::size_t i) {
  const Space<V> position = load_space<V>(work.position, i), half = load_space<V>(work.half_extent, i);
  Space<V> axes[3];
  find_axes(load_quat<V>(work.orientation, i), axes);
  const V row[15] = {position.x, position.y, position.z, axes[0].x, axes[0].y, axes[0].z, axes[1].x, axes[1].y,
                     axes[1].z,  axes[2].x,  axes[2].y,  axes[2].z, half.x,    half.y,    half.z};
  double* const frames = work.frames + i * kFrameDoubles;
  constexpr unsigned kFrom[] = {0, 4, 8, 11};
  for (const unsigned at : kFrom) scatter4(frames + at, kFrameDoubles, row + at);
  const auto reach = [&](V x, V y, V z) {
    const V along = (half.x * absolute(x) + half.y * absolute(y)) + half.z * absolute(z);
    return round_to(kPlaceMagic, along) + kPlaceStep;
  };
  const Space<V> reaches = {reach(axes[0].x, axes[1].x, axes[2].x), reach(axes[0].y, axes[1].y, axes[2].y),
                            reach(axes[0].z, axes[1].z, axes[2].z)};
  store_space(work.low, i, position - reaches);
  store_space(work.high, i, position + reaches);
}

template <class V>
void reach_out_pack(const ReachWork& work, std::size_t i) {
  const Space<V> spin = load_space<V>(work.spin, i), half = load_space<V>(work.half_extent, i);
  const V turning = square_root(dot(spin, spin)) * square_root(dot(half, half)) * work.dt_s;
  const V margin = round_to(kPlaceMagic, work.around + turning) + kPlaceStep;
  const Space<V> path = round_to(kPlaceMagic, load_space<V>(work.velocity, i) * (V{} + work.dt_s));
  const Space<V> low = load_space<V>(work.low, i), high = load_space<V>(work.high, i);
  const V zero = V{};
  store(work.turning + i, turning);
  store_space<V>(work.low, i,
                 {(low.x - margin) + smaller(path.x, zero), (low.y - margin) + smaller(path.y, zero),
                  (low.z - margin) + smaller(path.z, zero)});
  store_space<V>(work.high, i,
                 {(high.x + margin) + larger(path.x, zero), (high.y + margin) + larger(path.y, zero),
                  (high.z + margin) + larger(path.z, zero)});
}

// NaN fails every comparison, so the test is for what is wanted.
template <class V>
auto within(Space<V> a, double limit) {
  return (absolute(a.x) <= limit) & (absolute(a.y) <= limit) & (absolute(a.z) <= limit);
}

template <class V>
auto right(const CheckWork& work, std::size_t i) {
  const LaneQuat<V> q = load_quat<V>(work.orientation, i);
  const V norm = q.w * q.w + ((q.x * q.x + q.y * q.y) + q.z * q.z);
  return within(load_space<V>(work.position, i), work.position_max) &
         within(load_space<V>(work.velocity, i), work.speed_max) & within(load_space<V>(work.spin, i), work.speed_max) &
         (absolute(norm - 1.0) <= work.norm_tolerance);
}

template <int kWidth>
[[gnu::flatten]] std::size_t check(const CheckWork& work) {
  using V = typename VectorOf<kWidth>::Type;
  auto all = V{} == V{};
  std::size_t i = work.begin;
  for (; i + kWidth <= work.end; i += kWidth) all &= right<V>(work, i);
  for (int k = 0; k < kWidth; ++k) {
    if (all[k] == 0) return work.begin;
  }
  return i;
}

template <int kWidth>
[[gnu::flatten]] std::size_t fly(const FlightWork& work, std::size_t& uneven) {
  std::size_t i = work.begin;
  for (; i + kWidth <= work.end; i += kWidth) {
    unsigned any = 0;
    for (std::size_t k = i; k < i + kWidth; ++k) any |= work.flies[k];
    if (any != 0) fly_pack<typename VectorOf<kWidth>::Type>(work, i, uneven);
  }
  return i;
}
template <int kWidth>
[[gnu::flatten]] std::size_t frame(const FrameWork& work) {
  std::size_t i = work.begin;
  for (; i + kWidth <= work.end; i += kWidth) frame_pack<typename VectorOf<kWidth>::Type>(work, i);
  return i;
}
template <int kWidth>
[[gnu::flatten]] std::size_t reach_out(const ReachWork& work) {
  std::size_t i = work.begin;
  for (; i + kWidth <= work.end; i += kWidth) reach_out_pack<typename VectorOf<kWidth>::Type>(work, i);
  return i;
}

template <int kWidth>
constexpr BodyKernels body_kernels_of() {
  return {fly<kWidth>, frame<kWidth>, reach_out<kWidth>, check<kWidth>};
}

}  // namespace
}  // namespace tumble::sim
