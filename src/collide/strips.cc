#include "src/collide/strips.h"

#include <algorithm>
#include <array>
#include <limits>

#include "src/base/check.h"
#include "src/collide/sweep.h"
#include "src/sharing/key_counts.h"

namespace tumble::sim {
namespace {

constexpr double kStripWidth = 2;       // mean extents
constexpr double kBinWidth = 0.125;     // mean extents
constexpr double kBinReach = 1.01;      // bins; the product that finds one is rounded
constexpr double kCrowd = 8;            // boxes side by side in a strip, from which on the third axis pays
constexpr std::size_t kFewBodies = 48;  // for which one strip is enough

// The spread of the bodies along an axis.
struct Spread {
  int axis = 0;
  double low = 0, range = 0, extent = 0;  // m; extent: the mean, > 0

  [[nodiscard]] double extents() const { return range / extent; }
};

// The spreads along the three axes. Each worker looks at a range of bodies; how the sums of extents are rounded changes
// nothing but time.
std::array<Spread, 3> find_spreads(Scratch& scratch) {
  const std::size_t n = scratch.frames.size();
  const unsigned parts = scratch.homes.parts_for(scratch.workers, n, kBodiesAPart);
  std::vector<SweepScratch::Extents>& found = scratch.sweep.extents;
  found.resize(std::size_t{parts} * 3);
  work_together(scratch.workers, parts, [&](const Worker& worker) {
    for (int axis = 0; axis < 3; ++axis) {
      const std::vector<double>& low = column_of(scratch.aabb_low, axis);
      const std::vector<double>& high = column_of(scratch.aabb_high, axis);
      SweepScratch::Extents of = {std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest(), 0};
      scratch.homes.for_own(worker, n, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          of.lowest = std::min(of.lowest, low[i]);
          of.highest = std::max(of.highest, high[i]);
          of.sum += high[i] - low[i];
        }
      });
      found[worker.part * 3 + static_cast<unsigned>(axis)] = of;
    }
  });
  std::array<Spread, 3> spreads;
  for (unsigned axis = 0; axis < 3; ++axis) {
    SweepScratch::Extents all = found[axis];
    for (unsigned part = 1; part < parts; ++part) {
      const SweepScratch::Extents& of = found[part * 3 + axis];
      all = {std::min(all.lowest, of.lowest), std::max(all.highest, of.highest), all.sum + of.sum};
    }
    spreads[axis] = {static_cast<int>(axis), all.lowest, all.highest - all.lowest, all.sum / static_cast<double>(n)};
  }
  return spreads;
}

// The three axes, longest first, equals in their order: std::stable_sort would allocate.
std::array<Spread, 3> longest_first(Scratch& scratch) {
  std::array<Spread, 3> axes = find_spreads(scratch);
  const auto put_in_order = [](Spread& x, Spread& y) {
    if (y.extents() > x.extents()) std::swap(x, y);
  };
  put_in_order(axes[0], axes[1]);
  put_in_order(axes[1], axes[2]);
  put_in_order(axes[0], axes[1]);
  return axes;
}

// Parallel strips of equal width.
struct Strips {
  double low = 0, width = 1, per_width = 1;  // m, m, 1/m
  std::uint32_t count = 1;

  [[nodiscard]] std::uint32_t of(double x) const {
    return std::min(count - 1, static_cast<std::uint32_t>((x - low) * per_width));
  }
};

// The number of entries: one for each strip that each box reaches.
std::size_t entries_in(const Scratch& scratch, const Strips& strips, const std::vector<double>& low,
                       const std::vector<double>& high) {
  std::size_t entries = 0;
  const unsigned parts = scratch.homes.parts_for(scratch.workers, low.size(), kBodiesAPart);
  work_together(scratch.workers, parts, [&](const Worker& worker) {
    std::size_t here = 0;
    scratch.homes.for_own(worker, low.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) here += strips.of(high[i]) - strips.of(low[i]) + 1;
    });
    worker.add(entries, here);
  });
  return entries;
}

Strips strips_of_width(const Spread& spread, double width) {
  return {spread.low, width, 1 / width, static_cast<std::uint32_t>(spread.range / width) + 1};
}

Strips one_strip(const Spread& spread) { return strips_of_width(spread, 2 * spread.range + 1); }

// Strips across an axis, at most `most`. Narrow strips pay until large bodies among small ones lie in too many of them.
Strips lay_strips(const Scratch& scratch, const Spread& spread, double most) {
  const std::size_t n = scratch.frames.size();
  const std::vector<double>& low = column_of(scratch.aabb_low, spread.axis);
  const std::vector<double>& high = column_of(scratch.aabb_high, spread.axis);
  if (n < kFewBodies) return one_strip(spread);
  double width = std::max(kStripWidth * spread.extent, spread.range / most);
  while (entries_in(scratch, strips_of_width(spread, width), low, high) > 2 * n) width *= 2;
  return strips_of_width(spread, width);
}

// Sorts the bodies by their low ends along the first axis, to within a bin: enough for a sweep, in linear time.
void sort_into_bins(Scratch& scratch, const std::vector<double>& low, const Strips& bins, const Worker& worker) {
  SweepScratch& sweep = scratch.sweep;
  if (worker.first()) sweep.order.resize(low.size());
  KeyCounts counts(sweep.next, bins.count, worker);
  scratch.homes.for_own(worker, low.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) counts.add(bins.of(low[i]));
  });
  counts.find_places();
  scratch.homes.for_own(worker, low.size(), [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) sweep.order[counts.take(bins.of(low[i]))] = i;
  });
  worker.meet();
}

// Cells: crossings of a strip across the second axis with a strip across the third.
struct Cells {
  Strips second, third;

  [[nodiscard]] std::uint32_t count() const { return second.count * third.count; }
};

// Calls visit(cell) for each cell that a box reaches.
template <class Visit>
void for_cells(const Cells& cells, const SweepScratch::Box& box, Visit visit) {
  const std::uint32_t end2 = cells.second.of(box.high2), begin3 = cells.third.of(box.low3);
  const std::uint32_t end3 = cells.third.of(box.high3);
  for (std::uint32_t s = cells.second.of(box.low2); s <= end2; ++s) {
    for (std::uint32_t t = begin3; t <= end3; ++t) visit(s * cells.third.count + t);
  }
}

// Entries cell by cell, each cell in swept order. Each worker counts and places those of a range of boxes.
void fill_cells(SweepScratch& sweep, const Cells& cells, const Worker& worker) {
  const std::size_t count = cells.count();
  const Worker::Share share = worker.share(sweep.boxes.size());
  if (worker.first()) sweep.cell_start.resize(count + 1);
  KeyCounts counts(sweep.next, count, worker);
  for (std::size_t k = share.begin; k < share.end; ++k) {
    for_cells(cells, sweep.boxes[k], [&](std::uint32_t c) { counts.add(c); });
  }
  const std::uint32_t all = counts.find_places([&](std::size_t c, std::uint32_t at) { sweep.cell_start[c] = at; });
  if (worker.first()) {
    sweep.cell_start[count] = all;
    sweep.entries.resize(all);
  }
  worker.meet();
  for (std::size_t k = share.begin; k < share.end; ++k) {
    const SweepScratch::Box& box = sweep.boxes[k];
    for_cells(cells, box, [&](std::uint32_t c) { sweep.entries[counts.take(c)] = static_cast<std::uint32_t>(k); });
  }
  worker.meet();
}

// Finds the pairs of one cell. Entries are sorted to within `bin`, m, so the sweep looks that much farther, and tests
// the first axis too.
void sweep_cell(const SweepScratch& sweep, const Cells& cells, std::uint32_t cell, double bin, FoundPairs& found) {
  const std::size_t most = near_pairs_max(sweep.order.size());
  const SweepScratch::Box* const boxes = sweep.boxes.data();
  const std::uint32_t* const end = sweep.entries.data() + sweep.cell_start[cell + 1];
  for (const std::uint32_t* i = sweep.entries.data() + sweep.cell_start[cell]; i != end; ++i) {
    if (found.size() > most) return;
    const SweepScratch::Box& p = boxes[*i];
    const double limit = p.high1 + bin;
    for (const std::uint32_t* j = i + 1; j != end && boxes[*j].low1 <= limit; ++j) {
      const SweepScratch::Box& q = boxes[*j];
      // One branch, nearly always taken, instead of six unpredictable ones.
      const bool apart = static_cast<unsigned>(q.low1 > p.high1) | static_cast<unsigned>(p.low1 > q.high1) |
                         static_cast<unsigned>(q.low2 > p.high2) | static_cast<unsigned>(p.low2 > q.high2) |
                         static_cast<unsigned>(q.low3 > p.high3) | static_cast<unsigned>(p.low3 > q.high3);
      if (apart) continue;
      // A pair that shares several cells counts in the first.
      const std::uint32_t s = cells.second.of(std::max(p.low2, q.low2)), t = cells.third.of(std::max(p.low3, q.low3));
      if (s * cells.third.count + t == cell) found.push_back(std::minmax(sweep.order[*i], sweep.order[*j]));
    }
  }
}

void gather_boxes(Scratch& scratch, int first, int second, int third, const Worker::Share& share) {
  SweepScratch& sweep = scratch.sweep;
  const auto &low1 = column_of(scratch.aabb_low, first), &high1 = column_of(scratch.aabb_high, first);
  const auto &low2 = column_of(scratch.aabb_low, second), &high2 = column_of(scratch.aabb_high, second);
  const auto &low3 = column_of(scratch.aabb_low, third), &high3 = column_of(scratch.aabb_high, third);
  for (std::size_t k = share.begin; k < share.end; ++k) {
    const BodyIndex i = sweep.order[k];
    sweep.boxes[k] = {low1[i], high1[i], low2[i], high2[i], low3[i], high3[i]};
  }
}

void sweep_cells(SweepScratch& sweep, const Cells& cells, double bin, const Worker& worker) {
  FoundPairs& found = sweep.found_by[worker.part];
  found.clear();
  const Worker::Share own = worker.share_groups(sweep.cell_start);
  for (auto c = static_cast<std::uint32_t>(own.begin); c < own.end; ++c) sweep_cell(sweep, cells, c, bin, found);
}

// When the pairs of each body are sorted.
void write_pairs(const Scratch& scratch, PairTable& pairs, const Worker& worker, std::size_t bodies) {
  const SweepScratch& sweep = scratch.sweep;
  if (worker.first()) {
    pairs.a.resize(sweep.partner.size());
    pairs.b.resize(sweep.partner.size());
    pairs.planes.assign(sweep.partner.size(), 0);
  }
  worker.meet();
  scratch.homes.for_own(worker, bodies, [&](std::size_t begin, std::size_t end) {
    for (auto a = static_cast<BodyIndex>(begin); a < end; ++a) {
      for (std::uint32_t k = sweep.start[a]; k < sweep.start[a + 1]; ++k) {
        pairs.a[k] = a;
        pairs.b[k] = sweep.partner[k];
      }
    }
  });
}

}  // namespace

void find_overlaps_in_strips(Scratch& scratch, PairTable& pairs) {
  SweepScratch& sweep = scratch.sweep;
  const std::size_t n = scratch.frames.size();
  if (n == 0) {
    sweep.found_by.clear();
    sweep.partner.clear();
    pairs.clear();
    return;
  }
  const auto bodies = static_cast<double>(n);
  const std::array<Spread, 3> axes = longest_first(scratch);
  const Spread& first = axes[0];
  const double bin = std::max(kBinWidth * first.extent, first.range / (4 * bodies));
  SIM_DCHECK(bin > 0, bin);  // every box has an extent
  const Strips bins = strips_of_width(first, bin);
  Cells cells = {lay_strips(scratch, axes[1], bodies), one_strip(axes[2])};
  const double crowd = bodies / (std::max(1.0, first.extents()) * cells.second.count);
  if (crowd > kCrowd) cells.third = lay_strips(scratch, axes[2], 2 * bodies / cells.second.count);
  sweep.boxes.resize(n);
  const unsigned parts = scratch.homes.parts_for(scratch.workers, n, kBodiesAPart);
  if (sweep.found_by.size() < parts) sweep.found_by.resize(parts);
  work_together(scratch.workers, parts, [&](const Worker& worker) {
    sort_into_bins(scratch, column_of(scratch.aabb_low, first.axis), bins, worker);
    gather_boxes(scratch, first.axis, axes[1].axis, axes[2].axis, worker.share(n));
    fill_cells(sweep, cells, worker);
    sweep_cells(sweep, cells, kBinReach * bins.width, worker);
    sort_pairs(scratch, n, worker);
    write_pairs(scratch, pairs, worker, n);
  });
}

}  // namespace tumble::sim
