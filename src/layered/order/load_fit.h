#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "src/math/grid.h"
#include "src/world/phase_scratch.h"

namespace tumble::sim {

/// The load on each point under a body as a linear function of the point's place: the least-squares solution among all
/// loads that balance weight and moments.
struct LoadFit {
  double count = 0, x = 0, y = 0;             // number of points; m, mean place
  double xx = 0, xy = 0, yy = 0;              // m², sums of products about the mean
  double even = 0, along_x = 0, along_y = 0;  // kg, kg/m: load = even + along · (place − mean)

  // A point cannot pull, so negative loads are cut to 0.
  [[nodiscard]] double load_at(double at_x, double at_y) const {
    return std::max(0.0, even + (along_x * (at_x - x) + along_y * (at_y - y)));
  }
};

/// A body's mass with all that it bears, and the moments of that mass about the body's centre.
struct Borne {
  double mass = 0, moment_x = 0, moment_y = 0;  ///< kg; kg·m
};

/// balanced: also fits the moments; otherwise the loads are even. The order of the points does not show.
LoadFit fit_loads(std::span<const WeightScratch::SupportPoint> points, const Borne& borne, bool balanced);

}  // namespace tumble::sim
