#pragma once

#include <algorithm>

#include "src/math/grid.h"
#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// What sums of masses and their moments over the bodies of an island need, so that they are exact in any order.
struct IslandScale {
  double reach = 1;  ///< m, from the centre of a body to its corners, at least 1
  double magic = 0;  ///< of a grid that holds the sum of all masses times lever arms of twice the reach (math/grid.h)

  [[nodiscard]] double rounded(double x) const { return to_grid(magic, x); }
  /// A point where fast bodies will meet may lie farther from where the lower one is now.
  [[nodiscard]] double lever(double x) const { return std::clamp(x, -2 * reach, 2 * reach); }
};

/// Measures the islands of bodies that have contacts.
void measure_islands(const Bodies& bodies, Scratch& scratch);

/// The scale of the island of body i.
IslandScale scale_of(const IslandScratch& islands, BodyIndex i);

}  // namespace tumble::sim
