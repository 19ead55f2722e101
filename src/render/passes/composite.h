#pragma once

#include "src/render/passes/shader_program.h"
#include "tumble/sim/result.h"

namespace tumble::render {

/// Pass 6: the final image.
/// Reads:  the base image (`samples` times as large) with the masks in its alpha; the blurred image with the spread
///         HDR mask in its alpha
/// Writes: image(), 8 bits per channel, the picture: base and blurred mixed by the masks, the HDR mask added as glow
/// Source: thesis IV.F
class CompositePass {
 public:
  CompositePass() = default;
  static Result<CompositePass> create(const Gl& gl, int width, int height, int samples);
  void draw(const Gl& gl, const RenderTarget& base, const RenderTarget& blurred, bool with_bloom) const;
  [[nodiscard]] const RenderTarget& image() const { return image_; }

 private:
  ShaderProgram program_;
  RenderTarget image_;
  GlObject empty_;
  int samples_ = 1;
};

}  // namespace tumble::render
