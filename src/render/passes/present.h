#pragma once

#include "src/render/passes/shader_program.h"
#include "tumble/render/window.h"
#include "tumble/sim/result.h"

namespace tumble::render {

/// After the six passes, in a window only: copies the picture into a framebuffer of normalised bytes, the window's.
/// Reads:  the final image
/// Writes: a rectangle of the target. Sizes that differ are scaled without filtering
class PresentPass {
 public:
  PresentPass() = default;
  static Result<PresentPass> create(const Gl& gl);
  void draw(const Gl& gl, const RenderTarget& picture, const Target& target) const;

 private:
  ShaderProgram program_;
  GlObject empty_;
};

}  // namespace tumble::render
