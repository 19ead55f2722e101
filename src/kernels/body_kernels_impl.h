#pragma once

// Functions of single bodies for any number of lanes: the operations of free_flight, axes_of, reach_along and
// check_body in the order of those. lane_vector.h says who may include this.

#include "src/kernels/body_kernels.h"
#include "src/kernels/lanes/lane_rows.h"
#include "src/kernels/lanes/lane_vector.h"
#include "src/math/grid_magic.h"
#include "src/math/turn_series.h"
#include "tumble/sim/limits.h"

namespace tumble::sim {
namespace {

template <class V>
V on_grid(V x, double magic) {
  return ((x + magic) - magic) + 0.0;
}
template <class V>
Space<V> on_grid(const Space<V>& v, double magic) {
  return {on_grid(v.x, magic), on_grid(v.y, magic), on_grid(v.z, magic)};
}
template <class V>
Space<V> plus_zero(const Space<V>& v) {
  return {v.x + 0.0, v.y + 0.0, v.z + 0.0};
}

template <class V, class Column>
Space<V> load_space(Column const (&columns)[3], std::size_t at) {
  return {load<V>(columns[0] + at), load<V>(columns[1] + at), load<V>(columns[2] + at)};
}
template <class V>
void store_space(double* const (&columns)[3], std::size_t at, const Space<V>& v) {
  store(columns[0] + at, v.x);
  store(columns[1] + at, v.y);
  store(columns[2] + at, v.z);
}

template <class V, class Mask>
Space<V> chosen(Mask mask, const Space<V>& a, const Space<V>& b) {
  return {mask ? a.x : b.x, mask ? a.y : b.y, mask ? a.z : b.z};
}

template <class V>
struct Turn {
  V w, x, y, z;
};
template <class V>
Turn<V> load_turn(double* const (&columns)[4], std::size_t at) {
  return {load<V>(columns[0] + at), load<V>(columns[1] + at), load<V>(columns[2] + at), load<V>(columns[3] + at)};
}
template <class V>
V squared_length(const Turn<V>& q) {
  return q.w * q.w + ((q.x * q.x + q.y * q.y) + q.z * q.z);
}
// half_turn() of src/math/half_turn.h.
template <class V>
Turn<V> half_turn(const Space<V>& h) {
  const V squared = dot(h, h), one = V{} + 1.0;
  const auto fast = squared > kSlowHalfSquared;
  if (!any(fast)) return {one, h.x, h.y, h.z};
  const V half = square_root(squared);
  const V turns = (half * kInversePi + kWholeMagic) - kWholeMagic;
  const V rest = (half - turns * kPiHigh) - turns * kPiLow, x = rest * rest;
  const double* const n = kTangentN;
  const double* const d = kTangentD;
  const V sine = (((n[0] * x + n[1]) * x + n[2]) * x + n[3]) * x + n[4];
  const V cosine = ((((d[0] * x + d[1]) * x + d[2]) * x + d[3]) * x + d[4]) * x + d[5];
  const V part = fast ? sine * (rest / half) : one;
  return {fast ? cosine : one, h.x * part, h.y * part, h.z * part};
}
// turned() of src/math/half_turn.h.
template <class V>
Turn<V> turned(const Turn<V>& q, const Space<V>& h_W) {
  const Turn<V> h = half_turn(h_W);
  const Turn<V> p = {
      h.w * q.w - ((h.x * q.x + h.y * q.y) + h.z * q.z), (h.w * q.x + h.x * q.w) + (h.y * q.z - h.z * q.y),
      (h.w * q.y + h.y * q.w) + (h.z * q.x - h.x * q.z), (h.w * q.z + h.z * q.w) + (h.x * q.y - h.y * q.x)};
  const V n = square_root(squared_length(p));
  return {p.w / n + 0.0, p.x / n + 0.0, p.y / n + 0.0, p.z / n + 0.0};
}

template <int kWidth>
struct BytesOf {
  typedef std::uint8_t Type __attribute__((vector_size(kWidth)));  // NOLINT(modernize-use-using): GCC wants it so
};

template <class V>
auto bytes_at(const std::uint8_t* column, std::size_t at) {
  typename BytesOf<sizeof(V) / sizeof(double)>::Type bytes;
  __builtin_memcpy(&bytes, column + at, sizeof bytes);
  return bytes;
}

// For each lane, whether its body moves in free flight.
template <class V>
auto flying(const BodyColumns& b, const std::uint8_t* in_contact, std::size_t at) {
  if constexpr (sizeof(V) == sizeof(double)) {
    return (b.frozen[at] | b.is_static[at] | (in_contact == nullptr ? 0 : in_contact[at])) == 0;
  } else {
    auto bound = bytes_at<V>(b.frozen, at) | bytes_at<V>(b.is_static, at);
    if (in_contact != nullptr) bound |= bytes_at<V>(in_contact, at);
    return __builtin_convertvector(bound, decltype(V{} == V{})) == 0;
  }
}

// Calls visit(V{}, row) for whole vectors of rows, and for the last ones in narrower vectors.
template <int kWidth, class Visit>
void for_rows(Rows rows, Visit visit) {
  std::size_t at = rows.begin;
  for (; at + kWidth <= rows.end; at += kWidth) visit(typename VectorOf<kWidth>::Type{}, at);
  if constexpr (kWidth > 1) for_rows<kWidth / 2>({at, rows.end}, visit);
}

// Returns whether a body with different moments of inertia is left to move.
template <class V>
bool integrate_free_at(const BodyColumns& b, const std::uint8_t* in_contact, const Air& air, std::size_t at) {
  const auto all = flying<V>(b, in_contact, at);
  if (!any(all)) return false;
  const Space<V> inertia = load_space<V>(b.inertia, at);
  const auto flies = all & (inertia.x == inertia.y) & (inertia.y == inertia.z);
  const V slower = V{} + air.slower, half_s = V{} + 0.5 * air.dt_s;
  const auto slowed = [&](const Space<V>& v) {
    return on_grid(Space<V>{v.x / slower, v.y / slower, v.z / slower}, kMotionMagic);
  };
  const Space<V> before = load_space<V>(b.velocity, at), spin = load_space<V>(b.spin, at);
  const Space<V> faster = {before.x + air.gain[0], before.y + air.gain[1], before.z + air.gain[2]};
  const Space<V> after = air.drags ? slowed(faster) : plus_zero(faster);
  const Space<V> position = load_space<V>(b.position, at);
  const Space<V> there = plus_zero(position + on_grid((before + after) * half_s, kPlaceMagic));
  const Turn<V> q = load_turn<V>(b.orientation, at), p = turned(q, spin * half_s);
  store_space(b.position, at, chosen(flies, there, position));
  store_space(b.velocity, at, chosen(flies, after, before));
  if (air.drags) store_space(b.spin, at, chosen(flies, slowed(spin), spin));
  store(b.orientation[0] + at, flies ? p.w : q.w);
  store(b.orientation[1] + at, flies ? p.x : q.x);
  store(b.orientation[2] + at, flies ? p.y : q.y);
  store(b.orientation[3] + at, flies ? p.z : q.z);
  return any(all & (flies == 0));
}

template <int kWidth>
[[gnu::flatten]] bool integrate_free(const BodyColumns& b, Rows rows, const std::uint8_t* in_contact, const Air& air) {
  bool left = false;
  for_rows<kWidth>(rows,
                   [&](auto v, std::size_t at) { left |= integrate_free_at<decltype(v)>(b, in_contact, air, at); });
  return left;
}

// Writes frames and AABBs of as many bodies as V has lanes; axes as in axes_of. Returns whether all are in their fat
// AABBs.
template <class V>
bool put_boxes_at(const BodyColumns& b, const BoxColumns& boxes, std::size_t at) {
  const Space<V> position = load_space<V>(b.position, at), half = load_space<V>(b.half_extent, at);
  const Turn<V> q = load_turn<V>(b.orientation, at);
  const Space<V> axes[3] = {
      {1.0 - 2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y + q.w * q.z), 2.0 * (q.x * q.z - q.w * q.y)},
      {2.0 * (q.x * q.y - q.w * q.z), 1.0 - 2.0 * (q.x * q.x + q.z * q.z), 2.0 * (q.y * q.z + q.w * q.x)},
      {2.0 * (q.x * q.z + q.w * q.y), 2.0 * (q.y * q.z - q.w * q.x), 1.0 - 2.0 * (q.x * q.x + q.y * q.y)}};
  const auto grid_reach = [&](V along_x, V along_y, V along_z) {
    const V reach = (half.x * absolute(along_x) + half.y * absolute(along_y)) + half.z * absolute(along_z);
    return on_grid(reach, kPlaceMagic) + kPlaceStep;
  };
  const Space<V> reach = {grid_reach(axes[0].x, axes[1].x, axes[2].x), grid_reach(axes[0].y, axes[1].y, axes[2].y),
                          grid_reach(axes[0].z, axes[1].z, axes[2].z)};
  const Space<V> low = position - reach, high = position + reach;
  store_space(boxes.low, at, low);
  store_space(boxes.high, at, high);

  double* const rows = boxes.frames + at * kFrameDoubles;
  const V row[15] = {position.x, position.y, position.z, axes[0].x, axes[0].y, axes[0].z, axes[1].x, axes[1].y,
                     axes[1].z,  axes[2].x,  axes[2].y,  axes[2].z, half.x,    half.y,    half.z};
  constexpr unsigned kFirst[] = {0, 4, 8, 11};  // the last four overlap the four before
  for (const unsigned first : kFirst) scatter4(rows + first, kFrameDoubles, row + first);

  if (!boxes.fat) return false;
  const Space<V> fat_low = load_space<V>(boxes.fat_low, at), fat_high = load_space<V>(boxes.fat_high, at);
  const auto inside = (fat_low.x <= low.x) & (high.x <= fat_high.x) & (fat_low.y <= low.y) & (high.y <= fat_high.y) &
                      (fat_low.z <= low.z) & (high.z <= fat_high.z);
  return !any(inside == 0);
}

// Whether the boxes of all rows are up to date, because their bodies could not move since. Marks the rows whose boxes
// will be up to date from now on.
bool all_framed(const BodyColumns& b, const BoxColumns& boxes, Rows rows) {
  if (boxes.framed == nullptr) return false;
  bool all = true;
  for (std::size_t i = rows.begin; i < rows.end; ++i) {
    const bool rests = (b.frozen[i] | b.is_static[i]) != 0;
    all &= rests && boxes.framed[i] != 0;
    boxes.framed[i] = rests ? 1 : 0;
  }
  return all;
}

template <int kWidth>
[[gnu::flatten]] bool put_boxes(const BodyColumns& b, Rows rows, const BoxColumns& boxes) {
  bool inside = boxes.fat;
  for_rows<kWidth>(rows, [&](auto v, std::size_t at) {
    if (all_framed(b, boxes, {at, at + sizeof(v) / sizeof(double)})) return;
    inside &= put_boxes_at<decltype(v)>(b, boxes, at);
  });
  return inside;
}

template <class V>
void expand_aabbs_at(const BodyColumns& b, const ReachColumns& reach, std::size_t at) {
  const Space<V> spin = load_space<V>(b.spin, at), half = load_space<V>(b.half_extent, at);
  const V turning = square_root(dot(spin, spin)) * square_root(dot(half, half)) * reach.dt_s;
  const V margin = on_grid(reach.around + turning, kPlaceMagic) + kPlaceStep, zero = V{};
  const Space<V> path = on_grid(load_space<V>(b.velocity, at) * (V{} + reach.dt_s), kPlaceMagic);
  const Space<V> low = load_space<V>(reach.low, at), high = load_space<V>(reach.high, at);
  store(reach.turning + at, turning);
  store_space<V>(reach.low, at,
                 {(low.x - margin) + smaller(path.x, zero), (low.y - margin) + smaller(path.y, zero),
                  (low.z - margin) + smaller(path.z, zero)});
  store_space<V>(reach.high, at,
                 {(high.x + margin) + larger(path.x, zero), (high.y + margin) + larger(path.y, zero),
                  (high.z + margin) + larger(path.z, zero)});
}

template <int kWidth>
[[gnu::flatten]] void expand_aabbs(const BodyColumns& b, Rows rows, const ReachColumns& reach) {
  for_rows<kWidth>(rows, [&](auto v, std::size_t at) { expand_aabbs_at<decltype(v)>(b, reach, at); });
}

// NaN fails every comparison, so the test asks for the good case.
template <class V>
auto within(const Space<V>& v, double limit) {
  const auto x = absolute(v.x) <= limit, y = absolute(v.y) <= limit, z = absolute(v.z) <= limit;
  return x & y & z;
}

template <int kWidth>
[[gnu::flatten]] bool check(const BodyColumns& b, Rows rows) {
  bool wrong = false;
  for_rows<kWidth>(rows, [&](auto v, std::size_t at) {
    using V = decltype(v);
    const V norm = squared_length(load_turn<V>(b.orientation, at));
    const auto place = within(load_space<V>(b.position, at), kPositionMax);
    const auto speed = within(load_space<V>(b.velocity, at), kSpeedMax);
    const auto spin = within(load_space<V>(b.spin, at), kSpeedMax);
    const auto unit = absolute(norm - 1.0) <= kNormTolerance;
    const auto right = place & speed & spin & unit;
    wrong |= any(right == 0);
  });
  return !wrong;
}

template <int kWidth>
constexpr BodyKernels body_kernels_of() {
  return {integrate_free<kWidth>, put_boxes<kWidth>, expand_aabbs<kWidth>, check<kWidth>};
}

}  // namespace
}  // namespace tumble::sim
