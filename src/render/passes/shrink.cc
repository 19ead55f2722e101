#include "src/render/passes/shrink.h"

namespace tumble::render {
namespace {

const char* const kShrinkFragments = R"(
uniform usampler2D base;
uniform ivec2 last;   // texel of the base image
uniform int block;    // texels of it along one edge of a texel here
out vec4 colour;

float power_16(float x) {
  x *= x;
  x *= x;
  x *= x;
  return x * x;
}

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * block;
  vec4 sum = vec4(0.0);
  for (int y = 0; y < block; ++y) {
    for (int x = 0; x < block; ++x) {
      vec3 root = vec3(texelFetch(base, min(first + ivec2(x, y), last), 0).rgb) * (1.0 / 255.0);
      sum += vec4(root * root, power_16(min(root.r, min(root.g, root.b))));
    }
  }
  colour = sum / float(block * block);
}
)";

}  // namespace

Result<ShrinkPass> ShrinkPass::create(const Gl& gl, int width, int height, int samples) {
  ShrinkPass pass;
  pass.samples_ = samples;
  Result<ShaderProgram> program = ShaderProgram::create(gl, "the shrink pass", kFullScreenVertices, kShrinkFragments);
  if (!program.ok()) return program.error();
  pass.program_ = std::move(*program);
  Result<RenderTarget> image =
      RenderTarget::create(gl, (width + 3) / 4, (height + 3) / 4, RenderTarget::Format::kFloats);
  if (!image.ok()) return image.error();
  pass.image_ = std::move(*image);
  pass.empty_ = GlObject::make(gl, GlObject::Kind::kVertexArray);
  return pass;
}

void ShrinkPass::draw(const Gl& gl, const RenderTarget& base) const {
  image_.bind(gl);
  gl.Disable(GL_DEPTH_TEST);
  base.bind_texture(gl, 0);
  program_.use(gl);
  program_.set(gl, "base", 0);
  program_.set(gl, "last", base.width() - 1, base.height() - 1);
  program_.set(gl, "block", 4 * samples_);
  draw_full_screen(gl, empty_);
}

}  // namespace tumble::render
