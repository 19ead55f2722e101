#include "src/collide/strips.h"

#include <algorithm>
#include <cmath>

#include "src/collide/sweep.h"

namespace tumble::sim {
namespace {

constexpr double kStripWidth = 2;       // mean extents
constexpr std::size_t kFewBodies = 48;  // one strip will do

// How the bodies lie along an axis.
struct Spread {
  int axis = 0;
  double low = 0, high = 0, extent = 0;  // m; extent: the mean
};

Spread spread_along(const Scratch& scratch, int axis) {
  const std::vector<double>& low = column_of(scratch.aabb_low, axis);
  const std::vector<double>& high = column_of(scratch.aabb_high, axis);
  Spread spread{axis, low.front(), high.front(), 0};
  for (std::size_t i = 0; i < low.size(); ++i) {
    spread.low = std::min(spread.low, low[i]);
    spread.high = std::max(spread.high, high[i]);
    spread.extent += high[i] - low[i];
  }
  spread.extent /= static_cast<double>(low.size());
  return spread;
}

// Parallel strips of equal width.
struct Strips {
  double low = 0, width = 1;
  std::uint32_t count = 1;

  [[nodiscard]] std::uint32_t of(double x) const {
    return std::min(count - 1, static_cast<std::uint32_t>((x - low) / width));
  }
};

// How many entries the boxes make: one for each strip that each reaches.
std::size_t entries_in(const Strips& strips, const std::vector<double>& low, const std::vector<double>& high) {
  std::size_t entries = 0;
  for (std::size_t i = 0; i < low.size(); ++i) entries += strips.of(high[i]) - strips.of(low[i]) + 1;
  return entries;
}

// As narrow as it pays: large bodies among small ones would lie in very many.
Strips lay_strips(const Scratch& scratch, const Spread& spread) {
  const std::size_t n = scratch.frames.size();
  Strips strips;
  strips.low = spread.low;
  strips.width = spread.high - spread.low;
  if (n < kFewBodies || !(spread.extent > 0)) return strips;
  const std::vector<double>& low = column_of(scratch.aabb_low, spread.axis);
  const std::vector<double>& high = column_of(scratch.aabb_high, spread.axis);
  const double range = spread.high - spread.low;
  for (double width = kStripWidth * spread.extent; width < range; width *= 2) {
    if (range / width > static_cast<double>(n)) continue;
    strips.width = width;
    strips.count = static_cast<std::uint32_t>(range / width) + 1;
    if (entries_in(strips, low, high) <= 2 * n) return strips;
  }
  strips.width = range;
  strips.count = 1;
  return strips;
}

// Entries strip by strip, each strip in swept order.
void fill_strips(Scratch& scratch, const Strips& strips, int second) {
  SweepScratch& sweep = scratch.sweep;
  const int first = sweep.axis, third = 3 - first - second;
  const auto &low1 = column_of(scratch.aabb_low, first), &high1 = column_of(scratch.aabb_high, first);
  const auto &low2 = column_of(scratch.aabb_low, second), &high2 = column_of(scratch.aabb_high, second);
  const auto &low3 = column_of(scratch.aabb_low, third), &high3 = column_of(scratch.aabb_high, third);
  sweep.strip_start.assign(strips.count + 1, 0);
  for (std::size_t i = 0; i < low2.size(); ++i) {
    for (std::uint32_t s = strips.of(low2[i]); s <= strips.of(high2[i]); ++s) ++sweep.strip_start[s + 1];
  }
  for (std::uint32_t s = 0; s < strips.count; ++s) sweep.strip_start[s + 1] += sweep.strip_start[s];
  sweep.next.assign(sweep.strip_start.begin(), sweep.strip_start.end() - 1);
  const std::size_t entries = sweep.strip_start.back();
  sweep.boxes.resize(entries);
  sweep.body.resize(entries);
  sweep.strip_begin.resize(entries);
  for (const BodyIndex i : sweep.order) {
    const std::uint32_t begin = strips.of(low2[i]), end = strips.of(high2[i]);
    for (std::uint32_t s = begin; s <= end; ++s) {
      const std::uint32_t at = sweep.next[s]++;
      sweep.boxes[at] = {low1[i], high1[i], low2[i], high2[i], low3[i], high3[i]};
      sweep.body[at] = i;
      sweep.strip_begin[at] = begin;
    }
  }
}

void sweep_strip(SweepScratch& sweep, std::uint32_t strip) {
  const std::uint32_t end = sweep.strip_start[strip + 1];
  for (std::uint32_t i = sweep.strip_start[strip]; i < end; ++i) {
    const SweepScratch::Box& p = sweep.boxes[i];
    for (std::uint32_t j = i + 1; j < end && sweep.boxes[j].low1 <= p.high1; ++j) {
      const SweepScratch::Box& q = sweep.boxes[j];
      // One branch that is nearly always false, rather than four that nobody can guess.
      const bool apart = static_cast<unsigned>(q.low2 > p.high2) | static_cast<unsigned>(p.low2 > q.high2) |
                         static_cast<unsigned>(q.low3 > p.high3) | static_cast<unsigned>(p.low3 > q.high3);
      if (apart || std::max(sweep.strip_begin[i], sweep.strip_begin[j]) != strip) continue;
      sweep.found.push_back(std::minmax(sweep.body[i], sweep.body[j]));
    }
  }
}

}  // namespace

void find_overlaps_in_strips(Scratch& scratch, PairTable& pairs) {
  SweepScratch& sweep = scratch.sweep;
  sweep.found.clear();
  if (!scratch.frames.empty()) {
    sort_boxes(sweep, scratch);
    const Spread one = spread_along(scratch, (sweep.axis + 1) % 3), other = spread_along(scratch, (sweep.axis + 2) % 3);
    const bool second = (one.high - one.low) * other.extent >= (other.high - other.low) * one.extent;
    const Spread& across = second ? one : other;
    const Strips strips = lay_strips(scratch, across);
    fill_strips(scratch, strips, across.axis);
    for (std::uint32_t s = 0; s < strips.count; ++s) sweep_strip(sweep, s);
  }
  sort_pairs(sweep, scratch.frames.size());
  pairs.clear();
  for (BodyIndex a = 0; a + 1 < sweep.start.size(); ++a) {
    for (std::uint32_t k = sweep.start[a]; k < sweep.start[a + 1]; ++k) {
      pairs.a.push_back(a);
      pairs.b.push_back(sweep.partner[k]);
      pairs.planes.push_back(0);
    }
  }
}

}  // namespace tumble::sim
