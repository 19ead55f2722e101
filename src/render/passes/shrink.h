#pragma once

#include "src/render/passes/shader_program.h"
#include "tumble/sim/result.h"

namespace tumble::render {

/// Pass 3: the reduced image, which passes 4 and 5 blur.
/// Reads:  the base image, `samples` times as large as the picture
/// Writes: image(), a quarter as wide and high as the picture, floats. Red, green, blue: the mean of the texels it
///         covers, linear light. Alpha: the HDR mask, a power of the values of the base image. All values but white
///         go to zero without a threshold, which would flicker
/// Source: thesis IV.C
class ShrinkPass {
 public:
  ShrinkPass() = default;
  static Result<ShrinkPass> create(const Gl& gl, int width, int height, int samples);
  void draw(const Gl& gl, const RenderTarget& base) const;
  [[nodiscard]] const RenderTarget& image() const { return image_; }

 private:
  ShaderProgram program_;
  RenderTarget image_;
  GlObject empty_;
  int samples_ = 1;
};

}  // namespace tumble::render
