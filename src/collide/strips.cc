#include "src/collide/strips.h"

#include <algorithm>
#include <array>
#include <utility>

#include "src/collide/sweep.h"

namespace tumble::sim {
namespace {

constexpr double kStripWidth = 2;             // mean extents
constexpr double kBinWidth = 0.125;           // mean extents
constexpr double kBinReach = 1.01;            // bins; the product that finds one is rounded
constexpr double kCrowd = 8;                  // boxes side by side in a strip, from which on the third axis pays
constexpr std::size_t kFewBodies = 48;        // for which one strip is enough
constexpr std::size_t kWorthEntries = 49152;  // that pay for one more worker

// The spread of the bodies along an axis.
struct Spread {
  int axis = 0;
  double low = 0, range = 0, extent = 0;  // m; extent: the mean

  [[nodiscard]] double extents() const { return extent > 0 ? range / extent : 0; }
};

Spread spread_along(const Scratch& scratch, int axis) {
  const std::vector<double>& low = column_of(scratch.aabb_low, axis);
  const std::vector<double>& high = column_of(scratch.aabb_high, axis);
  double lowest = low.front(), highest = high.front(), extents = 0;
  for (std::size_t i = 0; i < low.size(); ++i) {
    lowest = std::min(lowest, low[i]);
    highest = std::max(highest, high[i]);
    extents += high[i] - low[i];
  }
  return {axis, lowest, highest - lowest, extents / static_cast<double>(low.size())};
}

// The three axes, longest first, equals in their order: std::stable_sort would allocate.
std::array<Spread, 3> longest_first(const Scratch& scratch) {
  std::array<Spread, 3> axes = {spread_along(scratch, 0), spread_along(scratch, 1), spread_along(scratch, 2)};
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
std::size_t entries_in(const Strips& strips, const std::vector<double>& low, const std::vector<double>& high) {
  std::size_t entries = 0;
  for (std::size_t i = 0; i < low.size(); ++i) entries += strips.of(high[i]) - strips.of(low[i]) + 1;
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
  if (n < kFewBodies || !(spread.extent > 0)) return one_strip(spread);
  double width = std::max(kStripWidth * spread.extent, spread.range / most);
  while (entries_in(strips_of_width(spread, width), low, high) > 2 * n) width *= 2;
  return strips_of_width(spread, width);
}

// Sorts the bodies by their low ends along the first axis, to within a bin: enough for a sweep, in linear time.
void sort_into_bins(SweepScratch& sweep, const std::vector<double>& low, const Strips& bins) {
  sweep.start.assign(bins.count + 1, 0);
  for (const double x : low) ++sweep.start[bins.of(x) + 1];
  for (std::uint32_t k = 0; k < bins.count; ++k) sweep.start[k + 1] += sweep.start[k];
  sweep.order.resize(low.size());
  for (BodyIndex i = 0; i < low.size(); ++i) sweep.order[sweep.start[bins.of(low[i])]++] = i;
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

// Entries cell by cell, each cell in swept order.
void fill_cells(SweepScratch& sweep, const Cells& cells) {
  sweep.cell_start.assign(cells.count() + 1, 0);
  for (const SweepScratch::Box& box : sweep.boxes)
    for_cells(cells, box, [&](std::uint32_t c) { ++sweep.cell_start[c + 1]; });
  for (std::uint32_t c = 0; c < cells.count(); ++c) sweep.cell_start[c + 1] += sweep.cell_start[c];
  sweep.next.assign(sweep.cell_start.begin(), sweep.cell_start.end() - 1);
  sweep.entries.resize(sweep.cell_start.back());
  for (std::size_t k = 0; k < sweep.boxes.size(); ++k) {
    const SweepScratch::Box& box = sweep.boxes[k];
    for_cells(cells, box, [&](std::uint32_t c) { sweep.entries[sweep.next[c]++] = {box, sweep.order[k]}; });
  }
}

// Finds the pairs of one cell. Entries are sorted to within `bin`, m, so the sweep looks that much farther, and tests
// the first axis too.
void sweep_cell(const SweepScratch& sweep, const Cells& cells, std::uint32_t cell, double bin, FoundPairs& found) {
  const std::size_t most = near_pairs_max(sweep.order.size());
  const SweepScratch::Entry* const end = sweep.entries.data() + sweep.cell_start[cell + 1];
  for (const SweepScratch::Entry* i = sweep.entries.data() + sweep.cell_start[cell]; i != end; ++i) {
    if (found.size() > most) return;
    const SweepScratch::Box& p = i->box;
    const double limit = p.high1 + bin;
    for (const SweepScratch::Entry* j = i + 1; j != end && j->box.low1 <= limit; ++j) {
      const SweepScratch::Box& q = j->box;
      // One branch, nearly always taken, instead of six unpredictable ones.
      const bool apart = static_cast<unsigned>(q.low1 > p.high1) | static_cast<unsigned>(p.low1 > q.high1) |
                         static_cast<unsigned>(q.low2 > p.high2) | static_cast<unsigned>(p.low2 > q.high2) |
                         static_cast<unsigned>(q.low3 > p.high3) | static_cast<unsigned>(p.low3 > q.high3);
      if (apart) continue;
      // A pair that shares several cells counts in the first.
      const std::uint32_t s = cells.second.of(std::max(p.low2, q.low2)), t = cells.third.of(std::max(p.low3, q.low3));
      if (s * cells.third.count + t == cell) found.push_back(std::minmax(i->body, j->body));
    }
  }
}

void gather_boxes(Scratch& scratch, int first, int second, int third) {
  SweepScratch& sweep = scratch.sweep;
  const auto &low1 = column_of(scratch.aabb_low, first), &high1 = column_of(scratch.aabb_high, first);
  const auto &low2 = column_of(scratch.aabb_low, second), &high2 = column_of(scratch.aabb_high, second);
  const auto &low3 = column_of(scratch.aabb_low, third), &high3 = column_of(scratch.aabb_high, third);
  sweep.boxes.resize(sweep.order.size());
  for (std::size_t k = 0; k < sweep.order.size(); ++k) {
    const BodyIndex i = sweep.order[k];
    sweep.boxes[k] = {low1[i], high1[i], low2[i], high2[i], low3[i], high3[i]};
  }
}

// Gives each worker cells with about one number of entries.
void sweep_cells(Scratch& scratch, const Cells& cells, double bin) {
  SweepScratch& sweep = scratch.sweep;
  const unsigned parts = part_count(scratch.workers, sweep.entries.size(), kWorthEntries);
  const std::vector<std::uint32_t>& start = sweep.cell_start;
  const auto first_cell = [&](unsigned part) {
    const std::size_t entry = sweep.entries.size() * part / parts;
    return static_cast<std::uint32_t>(std::lower_bound(start.begin(), start.end() - 1, entry) - start.begin());
  };
  if (sweep.found_by.size() < parts) sweep.found_by.resize(parts);
  for_parts(scratch.workers, parts, [&](unsigned part) {
    FoundPairs& found = part == 0 ? sweep.found : sweep.found_by[part];
    found.clear();
    const std::uint32_t end = part + 1 == parts ? cells.count() : first_cell(part + 1);
    for (std::uint32_t c = first_cell(part); c < end; ++c) sweep_cell(sweep, cells, c, bin, found);
  });
  for (unsigned part = 1; part < parts; ++part) {
    sweep.found.insert(sweep.found.end(), sweep.found_by[part].begin(), sweep.found_by[part].end());
  }
}

void find_in_cells(Scratch& scratch) {
  SweepScratch& sweep = scratch.sweep;
  const auto n = static_cast<double>(scratch.frames.size());
  const std::array<Spread, 3> axes = longest_first(scratch);
  const Spread& first = axes[0];
  const double bin = std::max(kBinWidth * first.extent, first.range / (4 * n));
  const Strips bins = strips_of_width(first, bin > 0 ? bin : 1);
  sort_into_bins(sweep, column_of(scratch.aabb_low, first.axis), bins);
  gather_boxes(scratch, first.axis, axes[1].axis, axes[2].axis);
  Cells cells = {lay_strips(scratch, axes[1], n), one_strip(axes[2])};
  const double crowd = n / (std::max(1.0, first.extents()) * cells.second.count);
  if (crowd > kCrowd) cells.third = lay_strips(scratch, axes[2], 2 * n / cells.second.count);
  fill_cells(sweep, cells);
  sweep_cells(scratch, cells, kBinReach * bins.width);
}

}  // namespace

void find_overlaps_in_strips(Scratch& scratch, PairTable& pairs) {
  SweepScratch& sweep = scratch.sweep;
  sweep.found.clear();
  if (!scratch.frames.empty()) find_in_cells(scratch);
  sort_pairs(scratch);
  pairs.a.resize(sweep.partner.size());
  for (BodyIndex a = 0; a + 1 < sweep.start.size(); ++a) {
    std::fill(pairs.a.begin() + sweep.start[a], pairs.a.begin() + sweep.start[a + 1], a);
  }
  pairs.b = sweep.partner;
  pairs.planes.assign(sweep.partner.size(), 0);
}

}  // namespace tumble::sim
