#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tumble/sim/vec.h"

namespace tumble::render {

/// Three indices of points, counter-clockwise seen from outside.
using HullFace = std::array<std::uint32_t, 3>;

/// The triangles of the convex hull of points, for pictures: a point within a billionth of the hull's size of a face
/// counts as on it. None where the points span no volume. Takes the points one after the other and replaces the faces
/// that a point sees by a fan from it over their rim; O(points × faces).
std::vector<HullFace> hull_faces(std::span<const sim::Vec3> points);

}  // namespace tumble::render
