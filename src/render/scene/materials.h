#pragma once

#include "src/render/gl/objects.h"
#include "tumble/render/snapshot.h"
#include "tumble/sim/result.h"

namespace tumble::render {

/// All materials in one array texture, one layer each (material_texels.h). OpenGL decodes the sRGB texels.
class Materials {
 public:
  Materials() = default;
  static Result<Materials> create(const Gl& gl);
  void bind_texture(const Gl& gl, int unit) const;

 private:
  GlObject texture_;
};

/// The difference between two bodies of equal material.
struct Variation {
  Colour tint;
  float offset_u = 0, offset_v = 0;  ///< of the texture, in edge lengths
};
Variation variation_of(const BoxLook& box);

}  // namespace tumble::render
