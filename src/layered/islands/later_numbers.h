#pragma once

#include <vector>

#include "src/world/scratch.h"

/// What later phases put in the place of numbers that carry_weights alone needs.
namespace tumble::sim {

/// part_overlaps: by the body that stands for an island, m, the deepest of its overlaps.
inline std::vector<double>& deepest_overlaps(Scratch& scratch) { return scratch.islands.heaviest; }

/// update_sleeping: s, the least time of rest of a body and of those that it touches.
inline std::vector<double>& least_rests(Scratch& scratch) { return scratch.weights.offered; }

/// update_sleeping: J/kg, by the body that stands for an island, the most that one of its bodies had before the step,
/// and what it has after it.
inline std::vector<double>& liveliest_before(Scratch& scratch) { return scratch.weights.moment_x; }
inline std::vector<double>& liveliest_after(Scratch& scratch) { return scratch.weights.moment_y; }

}  // namespace tumble::sim
