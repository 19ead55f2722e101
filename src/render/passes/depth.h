#pragma once

#include "src/render/passes/shader_program.h"
#include "src/render/scene/box_mesh.h"
#include "src/render/scene/solid_meshes.h"
#include "src/render/scene/view.h"
#include "tumble/sim/result.h"

namespace tumble::render {

/// Pass 1: the depth map for shadows.
/// Reads:  the bodies loaded into the meshes, without the ground; the light's view
/// Writes: texture(), size × size floats: depth of the surface next to the light, 0 … 1 from near to far
/// Source: thesis IV.B
class DepthPass {
 public:
  DepthPass() = default;
  static Result<DepthPass> create(const Gl& gl, int size);
  void draw(const Gl& gl, const BoxMesh& boxes, const SolidMeshes& solids, const View& light) const;
  /// Clears the map, so that nothing casts a shadow.
  void clear(const Gl& gl) const;

  [[nodiscard]] const RenderTarget& map() const { return map_; }

 private:
  ShaderProgram program_;
  RenderTarget map_;
};

}  // namespace tumble::render
