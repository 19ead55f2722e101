#pragma once

#include "src/render/passes/depth.h"
#include "src/render/passes/shader_program.h"
#include "src/render/scene/box_mesh.h"
#include "src/render/scene/materials.h"
#include "src/render/scene/solid_meshes.h"
#include "src/render/scene/view.h"
#include "tumble/render/effects.h"
#include "tumble/sim/result.h"

namespace tumble::render {

/// Pass 2: the base image.
/// Reads:  boxes, markers and ground of the snapshot; the materials; the depth map
/// Writes: image(), 8 bits a channel. Red, green, blue: lit and clamped at white, as square roots of linear light.
///         Alpha: the sum of the depth mask (how far out of focus) and the motion mask (how fast over the picture)
/// Source: thesis IV.A, B, D, E
class BasePass {
 public:
  BasePass() = default;
  /// width, height: of the base image, `samples` times those of the picture.
  static Result<BasePass> create(const Gl& gl, int width, int height);

  struct Scene {
    const Snapshot& snapshot;
    const View& camera;
    const View& light;
    const DepthPass& depth;
    const Materials& materials;
    const Effects& effects;
  };
  /// boxes: a mesh with the instances of the boxes of the snapshot, nearest first. solids: with those of its other
  /// bodies. scratch: any other mesh.
  void draw(const Gl& gl, const Scene& scene, const BoxMesh& boxes, const SolidMeshes& solids, BoxMesh& scratch) const;

  [[nodiscard]] const RenderTarget& image() const { return image_; }

 private:
  void set_uniforms(const Gl& gl, const Scene& scene, const ShaderProgram& program) const;
  void draw_background(const Gl& gl, const Scene& scene) const;

  ShaderProgram boxes_, solids_, background_;
  RenderTarget image_;
  GlObject empty_;
};

}  // namespace tumble::render
