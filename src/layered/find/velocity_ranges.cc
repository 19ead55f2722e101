#include "src/layered/find/velocity_ranges.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "src/layered/find/point_reach.h"
#include "src/math/grid.h"
#include "src/world/for_bodies.h"
#include "src/world/hash_on_the_way.h"
#include "tumble/sim/limits.h"

namespace tumble::sim {
namespace {

Vec3 velocity_of(const Bodies& bodies, BodyIndex i) {
  return bodies.moves(i) ? bodies.velocity[i] : Vec3(Vec3::Zero());
}

VelocityRange own_range(const Vec3& v) {
  VelocityRange range;
  for (int k = 0; k < 3; ++k) {
    range.low[k] = std::min(0.0, v[k]);
    range.opposite_high[k] = std::min(0.0, -v[k]);
  }
  return range;
}

// m/s, no less than any speed of the range.
double most(const VelocityRange& range) {
  Vec3 v;
  for (int k = 0; k < 3; ++k) v[k] = std::min(range.low[k], range.opposite_high[k]);
  return length(v);
}

// The largest speed of the range along n, m/s.
double along(const VelocityRange& range, const Vec3& n) {
  const auto part = [&](int k) { return n[k] > 0 ? -range.opposite_high[k] * n[k] : range.low[k] * n[k]; };
  return (part(0) + part(1)) + part(2);
}

// Whether any two bodies could be fast for their thickness; a quick no for most steps.
bool any_fast(const WorldState& state, const Scratch& scratch, double dt_s) {
  double squared_speed = 0, thin = kPositionMax;
  for_bodies(scratch, state.bodies.size(), [&](std::size_t begin, std::size_t end) {
    double fastest = 0, thinnest = kPositionMax;
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) {
      const Vec3 v = velocity_of(state.bodies, i);
      fastest = std::max(fastest, dot(v, v));
      thinnest = std::min(thinnest, scratch.frames[i].half_extent.minCoeff());
    }
    shared::raise(squared_speed, fastest);
    shared::lower(thin, thinnest);
  });
  return 4 * squared_speed * (dt_s * dt_s) > thin * thin;
}

void widen(VelocityRange& range, const VelocityRange& by) {
  for (int k = 0; k < 3; ++k) {
    shared::lower(range.low[k], by.low[k]);
    shared::lower(range.opposite_high[k], by.opposite_high[k]);
  }
}

}  // namespace

bool find_velocity_ranges(const WorldState& state, Scratch& scratch, double dt_s) {
  const Bodies& bodies = state.bodies;
  std::vector<VelocityRange>& ranges = scratch.ranges;
  ranges.clear();
  scratch.hit_unevenly.clear();
  if (!any_fast(state, scratch, dt_s)) return false;
  ranges.resize(bodies.size());
  scratch.hit_unevenly.resize(bodies.size());
  for_bodies(scratch, bodies.size(), [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) ranges[i] = own_range(velocity_of(bodies, i));
  });
  std::uint8_t any = 0;
  const PairTable& pairs = state.pairs;
  for_ranges(scratch.workers, pairs.size(), kManifoldsAPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const BodyIndex a = pairs.a[k], b = pairs.b[k];
      const Vec3 va = velocity_of(bodies, a), vb = velocity_of(bodies, b), between = vb - va;
      const double thin = smallest_half_extent(scratch.frames[a], scratch.frames[b]);
      if (dot(between, between) * (dt_s * dt_s) <= thin * thin) continue;
      if (bodies.moves(a)) widen(ranges[a], own_range(vb));
      if (bodies.moves(b)) widen(ranges[b], own_range(va));
      mark(any);
      const auto [light, heavy] = std::minmax({bodies.mass[a], bodies.mass[b]});
      if (heavy < kMuchHeavier * light) continue;
      mark(scratch.hit_unevenly[a]);
      mark(scratch.hit_unevenly[b]);
    }
  });
  return any != 0;
}

void widen_aabbs(const WorldState& state, Scratch& scratch, double dt_s) {
  for_bodies(scratch, state.bodies.size(), [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) {
      const VelocityRange own = own_range(velocity_of(state.bodies, i)), &all = scratch.ranges[i];
      const Vec3 low = scratch.aabb_low[i], high = scratch.aabb_high[i];
      scratch.aabb_low.set(i, low + PositionGrid::round(Vec3((all.low - own.low) * dt_s)));
      scratch.aabb_high.set(i, high - PositionGrid::round(Vec3((all.opposite_high - own.opposite_high) * dt_s)));
    }
  });
}

void hash_velocity_ranges(const Scratch& scratch, Hasher& hasher) {
  if (scratch.ranges.empty()) return;
  {
    GatheredNumbers numbers(&hasher);
    for (const VelocityRange& range : scratch.ranges) {
      numbers.add(range.low);
      numbers.add(range.opposite_high);
    }
  }
  hasher.add(std::span<const std::uint8_t>(scratch.hit_unevenly));
}

double fall_if_hit(const Scratch& scratch, BodyIndex i, double time_s) {
  if (scratch.ranges.empty()) return 0;
  const double fall = -scratch.ranges[i].low.z() * time_s;
  return fall > scratch.frames[i].half_extent.minCoeff() ? fall : 0;
}

double way_most_if_hit(const Scratch& scratch, BodyIndex a, BodyIndex b, double time_s) {
  if (scratch.ranges.empty()) return 0;
  const double thin = smallest_half_extent(scratch.frames[a], scratch.frames[b]);
  const double of_a = most(scratch.ranges[a]) * time_s, of_b = most(scratch.ranges[b]) * time_s;
  return std::max(of_a, of_b) > thin ? of_a + of_b : 0;
}

double way_if_hit(const Scratch& scratch, BodyIndex a, BodyIndex b, const Vec3& n, double time_s) {
  if (way_most_if_hit(scratch, a, b, time_s) == 0) return 0;
  return (along(scratch.ranges[a], n) + along(scratch.ranges[b], Vec3(-n))) * time_s;
}

double way_if_hit(const Scratch& scratch, const Manifold& m, double time_s) {
  return m.a == kGround ? fall_if_hit(scratch, m.b, time_s) : way_if_hit(scratch, m.a, m.b, m.n, time_s);
}

double ground_reach(const Bodies& bodies, const Scratch& scratch, BodyIndex i, double fall, double time_s) {
  const double slack = slack_of(scratch.frames[i].half_extent.minCoeff());
  const double way = std::max(-bodies.velocity.z[i] * time_s, fall_if_hit(scratch, i, time_s));
  return std::max(0.0, way) + (scratch.turning[i] + fall) + slack;
}

}  // namespace tumble::sim
