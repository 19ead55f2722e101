#include "src/render/passes/blur.h"

#include <algorithm>

namespace tumble::render {
namespace {

const char* const kBlurFragments = R"(
uniform sampler2D from;
uniform ivec2 direction, last;
uniform int radius, small_radius;   // texels to where the kernels reach zero
out vec4 colour;
void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  vec4 sum = vec4(0.0);
  for (int k = 1 - radius; k < radius; ++k) {
    float weight = float(radius - abs(k));
    float small_weight = float(max(small_radius - abs(k), 0));
    vec4 texel = texelFetch(from, clamp(here + direction * k, ivec2(0), last), 0);
    sum += texel * vec4(vec3(small_weight), weight);
  }
  float area = float(radius * radius), small_area = float(small_radius * small_radius);
  colour = sum / vec4(vec3(small_area), area);
}
)";

// Texels to where the kernel ends, to each side, of an image of this width: the whole kernel is 2/15 of it.
int mask_radius(int width) { return std::max((width + 14) / 15, 2); }
// The picture then is out of focus by 1/64 of its width.
int colour_radius(int width) { return std::max((width + 40) / 64 + 1, 2); }

}  // namespace

Result<BlurPass> BlurPass::create(const Gl& gl, int width, int height) {
  BlurPass pass;
  Result<ShaderProgram> program = ShaderProgram::create(gl, "the blur passes", kFullScreenVertices, kBlurFragments);
  if (!program.ok()) return program.error();
  pass.program_ = std::move(*program);
  Result<RenderTarget> image = RenderTarget::create(gl, width, height, RenderTarget::Format::kFloats);
  if (!image.ok()) return image.error();
  pass.image_ = std::move(*image);
  pass.empty_ = GlObject::make(gl, GlObject::Kind::kVertexArray);
  return pass;
}

void BlurPass::draw(const Gl& gl, const RenderTarget& from, bool along_y) const {
  image_.bind(gl);
  gl.Disable(GL_DEPTH_TEST);
  from.bind_texture(gl, 0);
  program_.use(gl);
  program_.set(gl, "from", 0);
  program_.set(gl, "direction", along_y ? 0 : 1, along_y ? 1 : 0);
  program_.set(gl, "last", image_.width() - 1, image_.height() - 1);
  program_.set(gl, "radius", mask_radius(image_.width()));
  program_.set(gl, "small_radius", colour_radius(image_.width()));
  draw_full_screen(gl, empty_);
}

}  // namespace tumble::render
