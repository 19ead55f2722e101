#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tumble/sim/vec.h"

/// Surfaces of bodies that are no boxes, made of triangles. Computed with + − × ÷ and sqrt only, so that a picture's
/// triangles are equal on all machines.
namespace tumble::render {

/// A corner of a triangle, in the body's own axes around its centre.
struct SolidVertex {
  float at[3];      ///< m
  float normal[3];  ///< unit; of the face, or of the round surface
  float place[3];   ///< on the surface, m: around and along; 0
};

/// Three corners each, counter-clockwise seen from outside.
struct Solid {
  std::vector<SolidVertex> corners;
};

inline constexpr int kSolidParts = 48;  ///< of a circle

/// radius > 0; half_length >= 0: of the straight part along `axis` (0 x, 1 y, 2 z). A sphere has none.
Solid make_capsule(int axis, double radius, double half_length);
Solid make_cylinder(int axis, double radius, double half_length);

/// The convex hull of points. Points that span no volume give no corners.
Solid make_hull(std::span<const sim::Vec3> points);

/// Triangles: three indices into `points` each. Both sides are drawn, so their sense does not matter.
Solid make_mesh(std::span<const sim::Vec3> points, std::span<const std::uint32_t> triangles);

}  // namespace tumble::render
