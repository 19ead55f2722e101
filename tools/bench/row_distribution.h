#pragma once

#include <optional>
#include <vector>

#include "tumble/replay/body_states.h"
#include "tumble/sim/scene.h"

namespace tumble::tools {

/// The distribution of the comparison scene's cubes along y, the direction in which they fall and roll: the thesis's
/// second criterion of accuracy (V.A).
struct RowDistribution {
  std::vector<double> y;  ///< m, of each cube, ascending; cubes lost in the ground or beyond numbers are left out
  double mean = 0;        ///< m
  double farthest = 0;    ///< m, the largest mean of a row's cubes
};

/// Of a grid's bodies in the last state of a session; `states` has the bodies of `scene` in its order of ids.
RowDistribution distribution_of(const sim::SceneDef& scene, const replay::BodyStates& states);

/// The distance of two distributions, m: the mean of |y_a − y_b| over cubes matched in ascending order, which is the
/// least mean way that turns one distribution into the other (the first Wasserstein distance). Cubes that change places
/// do not count. None where either has no cube.
std::optional<double> distance(const RowDistribution& a, const RowDistribution& b);

}  // namespace tumble::tools
