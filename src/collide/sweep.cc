#include "src/collide/sweep.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "src/base/check.h"
#include "src/kernels/kernels_by_width.h"
#include "src/math/grid.h"
#include "src/sharing/key_counts.h"
#include "src/world/body_columns.h"
#include "src/world/hash_on_the_way.h"

namespace tumble::sim {
namespace {

constexpr std::size_t kSamples = 64;  // bodies that judge an axis
constexpr int kAxisLifetime = 64;     // sweeps until the axes are judged again
constexpr double kFatPart = 0.1;      // of the extent, margin of a fat AABB
constexpr double kFatSubsteps = 4;    // of the motion, margin ahead

void sort_by_low(std::vector<BodyIndex>& order, const std::vector<double>& low) {
  const std::size_t n = low.size();
  order.resize(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<BodyIndex>(i);
  std::sort(order.begin(), order.end(), [&](BodyIndex i, BodyIndex j) { return low[i] < low[j]; });
}

// Starts from the order of the last substep: bodies move little, so insertion sort is nearly linear.
void sort_again(std::vector<BodyIndex>& order, const std::vector<double>& low) {
  for (std::size_t i = 1; i < order.size(); ++i) {
    const BodyIndex body = order[i];
    std::size_t j = i;
    for (; j > 0 && low[order[j - 1]] > low[body]; --j) order[j] = order[j - 1];
    order[j] = body;
  }
}

// The number of bodies that a sweep along this axis would meet, estimated from a sample.
std::size_t overlaps_met(const std::vector<BodyIndex>& order, const std::vector<double>& low,
                         const std::vector<double>& high) {
  const std::size_t n = order.size(), stride = std::max<std::size_t>(1, n / kSamples);
  std::size_t met = 0;
  for (std::size_t i = 0; i < n; i += stride) {
    const double end = high[order[i]];
    const auto first = order.begin() + static_cast<std::ptrdiff_t>(i);
    met += static_cast<std::size_t>(
        std::upper_bound(first, order.end(), end, [&](double x, BodyIndex body) { return x < low[body]; }) - first);
  }
  return met;
}

// Sorts the boxes along the axis whose sweep meets the fewest others. That axis changes slowly, and the choice changes
// nothing but time, so the axes are judged only now and then.
void sort_boxes(SweepScratch& sweep) {
  const std::size_t n = sweep.fat_low.size();
  if (sweep.order.size() == n && ++sweep.age < kAxisLifetime) {
    return sort_again(sweep.order, column_of(sweep.fat_low, sweep.axis));
  }
  std::vector<BodyIndex>& order = sweep.judged;
  std::size_t fewest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double>& low = column_of(sweep.fat_low, axis);
    sort_by_low(order, low);
    const std::size_t met = overlaps_met(order, low, column_of(sweep.fat_high, axis));
    if (axis > 0 && met >= fewest) continue;
    fewest = met;
    sweep.axis = axis;
    sweep.order = order;
  }
  sweep.age = 0;
}

// Copies the extents in swept order, so that the sweep reads memory forwards.
void gather(SweepScratch& sweep) {
  const std::vector<BodyIndex>& order = sweep.order;
  const std::size_t n = order.size();
  sweep.boxes.resize(n);
  const int first = sweep.axis, second = (first + 1) % 3, third = (first + 2) % 3;
  const auto& low1 = column_of(sweep.fat_low, first);
  const auto& low2 = column_of(sweep.fat_low, second);
  const auto& low3 = column_of(sweep.fat_low, third);
  const auto& high1 = column_of(sweep.fat_high, first);
  const auto& high2 = column_of(sweep.fat_high, second);
  const auto& high3 = column_of(sweep.fat_high, third);
  for (std::size_t k = 0; k < n; ++k) {
    const BodyIndex i = order[k];
    sweep.boxes[k] = {low1[i], high1[i], low2[i], high2[i], low3[i], high3[i]};
  }
}

// Finds every overlapping pair once, smaller index first, in swept order.
void sweep_pairs(SweepScratch& sweep, FoundPairs& found) {
  found.clear();
  const std::vector<BodyIndex>& order = sweep.order;
  const std::size_t n = order.size();
  for (std::size_t i = 0; i < n && found.size() <= near_pairs_max(n); ++i) {
    const SweepScratch::Box& p = sweep.boxes[i];
    for (std::size_t j = i + 1; j < n && sweep.boxes[j].low1 <= p.high1; ++j) {
      const SweepScratch::Box& q = sweep.boxes[j];
      // One branch, nearly always taken, instead of four unpredictable ones.
      const bool apart = static_cast<unsigned>(q.low2 > p.high2) | static_cast<unsigned>(p.low2 > q.high2) |
                         static_cast<unsigned>(q.low3 > p.high3) | static_cast<unsigned>(p.low3 > q.high3);
      if (!apart) {
        found.push_back(std::minmax(order[i], order[j]));
      }
    }
  }
}

// Writes the fat AABBs: a part of the extent on every side, and the way of ahead_s seconds in front.
void widen_boxes(Scratch& scratch, const Vec3Column& velocity, double part, double ahead_s) {
  SweepScratch& sweep = scratch.sweep;
  const std::size_t n = scratch.frames.size();
  sweep.fat_low.resize(n);
  sweep.fat_high.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 low = scratch.aabb_low[i], high = scratch.aabb_high[i], path = velocity[i] * ahead_s;
    const Vec3 around = (high - low) * part;
    sweep.fat_low.set(i, low - around + path.cwiseMin(Vec3::Zero()));
    sweep.fat_high.set(i, high + around + path.cwiseMax(Vec3::Zero()));
  }
}

void find_neighbours(Scratch& scratch) {
  SweepScratch& sweep = scratch.sweep;
  sort_boxes(sweep);
  gather(sweep);
  sweep.found_by.resize(1);
  sweep_pairs(sweep, sweep.found_by[0]);
  sort_pairs(scratch, scratch.frames.size(), {});
  sweep.neighbours.clear();
  for (BodyIndex a = 0; a < sweep.fat_low.size(); ++a) {
    for (std::uint32_t k = sweep.start[a]; k < sweep.start[a + 1]; ++k)
      sweep.neighbours.emplace_back(a, sweep.partner[k]);
  }
}

[[maybe_unused]] bool all_in_fat_aabbs(const Scratch& scratch) {
  const SweepScratch& sweep = scratch.sweep;
  for (std::size_t i = 0; i < scratch.frames.size(); ++i) {
    const Vec3 below = scratch.aabb_low[i] - sweep.fat_low[i], above = sweep.fat_high[i] - scratch.aabb_high[i];
    if (below.minCoeff() < 0 || above.minCoeff() < 0) return false;
  }
  return true;
}

bool overlap(const Vec3Column& low, const Vec3Column& high, BodyIndex a, BodyIndex b) {
  const unsigned apart = static_cast<unsigned>(low.x[a] > high.x[b]) | static_cast<unsigned>(low.x[b] > high.x[a]) |
                         static_cast<unsigned>(low.y[a] > high.y[b]) | static_cast<unsigned>(low.y[b] > high.y[a]) |
                         static_cast<unsigned>(low.z[a] > high.z[b]) | static_cast<unsigned>(low.z[b] > high.z[a]);
  return apart == 0;
}

}  // namespace

Status check_crowd(const Scratch& scratch) {
  const std::size_t n = scratch.frames.size(), most = near_pairs_max(n);
  if (scratch.sweep.partner.size() <= most) return {};
  return cannot_finish("found more than " + std::to_string(most) + " pairs of " + std::to_string(n) +
                       " bodies near one another; so many stand inside one another: set them farther apart");
}

void sort_pairs(Scratch& scratch, std::size_t bodies, const Worker& worker) {
  SweepScratch& sweep = scratch.sweep;
  const FoundPairs& found = sweep.found_by[worker.part];
  if (worker.first()) sweep.start.resize(bodies + 1);
  KeyCounts counts(sweep.next, bodies, worker);
  for (const auto& pair : found) counts.add(pair.first);
  const std::uint32_t all = counts.find_places([&](std::size_t a, std::uint32_t at) { sweep.start[a] = at; });
  if (worker.first()) {
    sweep.start[bodies] = all;
    sweep.partner.resize(all);
  }
  worker.meet();
  for (const auto& [a, b] : found) sweep.partner[counts.take(a)] = b;
  worker.meet();
  scratch.homes.for_own(worker, bodies, [&](std::size_t begin, std::size_t end) {
    for (std::size_t a = begin; a < end; ++a) {
      std::sort(sweep.partner.begin() + sweep.start[a], sweep.partner.begin() + sweep.start[a + 1]);
    }
  });
  worker.meet();
}

BoxColumns box_columns_of(Scratch& scratch, std::size_t n) {
  scratch.frames.resize(n);
  scratch.aabb_low.resize(n);
  scratch.aabb_high.resize(n);
  static_assert(sizeof(BoxFrame) == 15 * sizeof(double));
  BoxColumns columns;
  columns.frames = reinterpret_cast<double*>(scratch.frames.data());
  put_pointers(scratch.aabb_low, columns.low);
  put_pointers(scratch.aabb_high, columns.high);
  return columns;
}

void update_frames(Bodies& bodies, Scratch& scratch, Hasher* hasher) {
  const std::size_t n = bodies.size();
  const BodyColumns columns = columns_of(bodies);
  const BoxColumns boxes = box_columns_of(scratch, n);
  const auto update = [&](std::size_t begin, std::size_t end) {
    kernels(scratch.lanes).bodies.put_boxes(columns, {begin, end}, boxes);
  };
  for_hashed_bodies(hasher, scratch, n, kBodiesABlock, update,
                    [&](std::size_t begin, std::size_t end) { hasher->add(doubles_of(scratch.frames, begin, end)); });
}

void hash_frames(const Scratch& scratch, Hasher& hasher) { hasher.add(doubles_of(scratch.frames)); }

void renew_neighbours(const Vec3Column& velocity, double dt_s, Scratch& scratch) {
  widen_boxes(scratch, velocity, kFatPart, kFatSubsteps * dt_s);
  find_neighbours(scratch);
  if (check_crowd(scratch).ok()) return;
  widen_boxes(scratch, velocity, 0, 0);  // thin AABBs have fewer overlaps
  find_neighbours(scratch);
}

void find_overlaps(Scratch& scratch, PairTable& pairs) {
  SIM_DCHECK(all_in_fat_aabbs(scratch));
  SweepScratch& sweep = scratch.sweep;
  PairTable& merged = sweep.merged;
  merged.clear();
  std::size_t old = 0;
  for (const auto& [a, b] : sweep.neighbours) {
    if (!overlap(scratch.aabb_low, scratch.aabb_high, a, b)) continue;
    while (old < pairs.size() && (pairs.a[old] < a || (pairs.a[old] == a && pairs.b[old] < b))) ++old;
    const bool known = old < pairs.size() && pairs.a[old] == a && pairs.b[old] == b;
    merged.a.push_back(a);
    merged.b.push_back(b);
    merged.planes.push_back(known ? pairs.planes[old] : std::uint16_t{0});
  }
  std::swap(pairs, merged);
}

}  // namespace tumble::sim
