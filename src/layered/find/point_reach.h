#pragma once

#include <span>
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

/// Where the points lie as the boxes will meet, `later` s from now: makes the separations those of now.
void separate_as_now(const Bodies& bodies, const Manifold& m, double later, std::span<ManifoldPoint> points);

}  // namespace tumble::sim
