#pragma once

#include <vector>

#include "tumble/sim/manifold.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Which points of a manifold count.
struct PointReach {
  double time_s;     ///< points that cannot meet so soon are left out
  double pushing_s;  ///< points that would meet so soon push
  double margin;     ///< m, at which points meet
};

/// Removes the points of the last manifold that cannot meet. Returns whether one that is left pushes.
bool leave_points_in_reach(const Bodies& bodies, const PointReach& reach, Manifold& m,
                           std::vector<ManifoldPoint>& points);

}  // namespace tumble::sim
