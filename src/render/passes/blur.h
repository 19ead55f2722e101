#pragma once

#include "src/render/passes/shader_program.h"
#include "tumble/sim/result.h"

namespace tumble::render {

/// Passes 4 and 5: the blurred image, filtered along x, then along y, by linear (tent-shaped) kernels: a wide one for
/// the HDR mask, at least 1/15 of the picture's width, and a smaller one for the colours.
/// Reads:  the image of pass 3, or of pass 4
/// Writes: image(), of the same size and meaning
/// Source: thesis IV.C (separable linear filter), D (the smaller kernel)
class BlurPass {
 public:
  BlurPass() = default;
  /// width, height: of the filtered image.
  static Result<BlurPass> create(const Gl& gl, int width, int height);
  void draw(const Gl& gl, const RenderTarget& from, bool along_y) const;
  [[nodiscard]] const RenderTarget& image() const { return image_; }

 private:
  ShaderProgram program_;
  RenderTarget image_;
  GlObject empty_;
};

}  // namespace tumble::render
