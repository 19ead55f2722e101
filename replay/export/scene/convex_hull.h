#pragma once

#include <cstdint>
#include <vector>

#include "tumble/sim/vec.h"

namespace tumble::replay {

/// The triangles of the convex hull of points, for pictures: three indices each, counter-clockwise from outside. Points
/// nearer than a billionth of the extent to a face count as on it. Empty for points on one plane.
std::vector<std::uint32_t> convex_hull(const std::vector<sim::Vec3>& points);

}  // namespace tumble::replay
