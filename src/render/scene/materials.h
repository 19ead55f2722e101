#pragma once

#include "src/base/result.h"
#include "src/render/gl/objects.h"
#include "src/render/scene/snapshot.h"

namespace tumble::render {

/// All materials as one array texture, a layer each (material_texels.h). sRGB texels are decoded by the hardware.
class Materials {
 public:
  Materials() = default;
  static Result<Materials> create(const Gl& gl);
  void bind_texture(const Gl& gl, int unit) const;

 private:
  GlObject texture_;
};

/// How one body's material differs from another's of the same kind.
struct Variation {
  Colour tint;
  float offset_u = 0, offset_v = 0;  ///< of the texture, in its edges
};
Variation variation_of(const BoxLook& box);

}  // namespace tumble::render
