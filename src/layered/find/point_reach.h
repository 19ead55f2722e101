#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "src/base/large_vector.h"
#include "src/collide/box_pair.h"
#include "tumble/sim/manifold.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// The slack: points that may come this close within a step become contact points. The slack is kContactSlack (m), or
/// kContactSlackPart of the smallest half extent of the two boxes where that is less.
inline constexpr double kContactSlack = 0.01;
inline constexpr double kContactSlackPart = 0.05;

/// The slack of boxes with this smallest half extent, m.
inline double slack_of(double smallest) { return std::min(kContactSlack, kContactSlackPart * smallest); }

/// Which points of a manifold count.
struct PointReach {
  double time_s;     ///< points that cannot meet so soon are left out
  double pushing_s;  ///< points that would meet so soon push
  double margin;     ///< m, at which points meet
};

/// Removes the points of the last manifold that cannot meet. Returns whether one that is left pushes.
bool leave_points_in_reach(const Bodies& bodies, const PointReach& reach, Manifold& m,
                           LargeVector<ManifoldPoint>& points);

/// Where the points lie as the boxes will meet, `later` s from now: makes the separations those of now.
void separate_as_now(const Bodies& bodies, const Manifold& m, double later, std::span<ManifoldPoint> points);

}  // namespace tumble::sim
