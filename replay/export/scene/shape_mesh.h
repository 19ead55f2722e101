#pragma once

#include <cstdint>
#include <vector>

#include "replay/export/plan/export_plan.h"
#include "tumble/sim/vec.h"

/// The surfaces of bodies and the ground as triangles.
namespace tumble::replay {

/// Floats as graphics formats have them. Triangles run counter-clockwise seen from outside. A vertex belongs to one
/// face where an edge is sharp.
struct TriangleMesh {
  std::vector<float> positions;  ///< three a vertex, m, in the body's own axes
  std::vector<float> normals;    ///< three a vertex, unit
  std::vector<float> uvs;        ///< two a vertex, of the texture
  std::vector<std::uint32_t> indices;
  [[nodiscard]] std::size_t vertices() const { return positions.size() / 3; }
};

/// The surface of a body: of its shape, else of the box of its size. Textures lie on boxes as `tumble render` draws
/// them, but for the shift of each body.
TriangleMesh mesh_of(const ExportBody& body);

inline constexpr double kGroundEdge = 100;  ///< m, of the ground that is drawn

/// A square of the plane z = 0 with its middle in the origin.
TriangleMesh ground_mesh(double edge);

}  // namespace tumble::replay
