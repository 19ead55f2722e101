#pragma once

#include <cstdint>
#include <span>

#include "src/kernels/box_frame.h"
#include "tumble/replay/shape.h"

/// Bodies of other engines by their own shapes: how far they reach, how deep they overlap, how hard they are to turn.
namespace tumble::replay {

/// A body at its place: a shape, or the box of its size.
struct Solid {
  sim::BoxFrame frame;
  const Shape* shape = nullptr;  ///< null: the box
  /// Its surface is no bound of a convex solid; such a body has no overlaps.
  [[nodiscard]] bool is_mesh() const { return shape != nullptr && shape->kind == Shape::Kind::kMesh; }
};

/// How far a body reaches from its centre along a direction of unit length, m. Exact; of hull and mesh by their points.
double reach_of(const Solid& body, const sim::Vec3& direction);

/// The depth of the lowest point under z = 0, m; 0 above.
double ground_penetration(const Solid& body);

/// The depth to which two bodies overlap, m; 0 when they are apart. Exact between boxes, spheres and capsules, but for
/// a capsule and a box; else the least of the directions tried: at most this deep. Neither may be a mesh.
double overlap_depth(const Solid& a, const Solid& b);
bool overlap_is_exact(const Solid& a, const Solid& b);

/// The deepest overlap of any two bodies that are no meshes, m; 0 if none. A pair with both bodies left out does not
/// count. upper_bound: set where the result may be less deep.
double deepest_overlap(std::span<const Solid> bodies, std::span<const std::uint8_t> left_out, bool& upper_bound);

/// The principal moments of inertia of a solid of uniform density about its own axes, kg·m². Of hull and mesh those of
/// the box `size` around them, m.
sim::Vec3 inertia_of(const Shape& shape, double mass, const sim::Vec3& size);

}  // namespace tumble::replay
