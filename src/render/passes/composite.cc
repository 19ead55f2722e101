#include "src/render/passes/composite.h"

namespace tumble::render {
namespace {

const char* const kCompositeFragments = R"(
uniform usampler2D base;
uniform sampler2D blurred;
uniform vec2 covered;   // pixels that the blurred image covers
uniform int samples;
uniform float glow;
out uvec4 final;
void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * samples;
  vec4 soft = texture(blurred, gl_FragCoord.xy / covered);
  vec3 colour = vec3(0.0);
  for (int y = 0; y < samples; ++y) {
    for (int x = 0; x < samples; ++x) {
      vec4 texel = vec4(texelFetch(base, first + ivec2(x, y), 0)) * (1.0 / 255.0);
      colour += mix(texel.rgb * texel.rgb, soft.rgb, texel.a);
    }
  }
  colour = colour / float(samples * samples) + vec3(1.0, 0.98, 0.93) * (soft.a * glow);
  final = uvec4(vec4(sqrt(clamp(colour, 0.0, 1.0)), 1.0) * 255.0 + 0.5);
}
)";

constexpr float kGlow = 0.75F;

}  // namespace

Result<CompositePass> CompositePass::create(const Gl& gl, int width, int height, int samples) {
  CompositePass pass;
  pass.samples_ = samples;
  Result<ShaderProgram> program =
      ShaderProgram::create(gl, "the composite pass", kFullScreenVertices, kCompositeFragments);
  if (!program.ok()) return program.error();
  pass.program_ = std::move(*program);
  Result<RenderTarget> image = RenderTarget::create(gl, width, height, RenderTarget::Format::kBytes);
  if (!image.ok()) return image.error();
  pass.image_ = std::move(*image);
  pass.empty_ = GlObject::make(gl, GlObject::Kind::kVertexArray);
  return pass;
}

void CompositePass::draw(const Gl& gl, const RenderTarget& base, const RenderTarget& blurred, bool with_bloom) const {
  image_.bind(gl);
  gl.Disable(GL_DEPTH_TEST);
  base.bind_texture(gl, 0);
  blurred.bind_texture(gl, 1);
  program_.use(gl);
  program_.set(gl, "base", 0);
  program_.set(gl, "blurred", 1);
  program_.set(gl, "covered", static_cast<float>(4 * blurred.width()), static_cast<float>(4 * blurred.height()));
  program_.set(gl, "samples", samples_);
  program_.set(gl, "glow", with_bloom ? kGlow : 0.0F);
  draw_full_screen(gl, empty_);
}

}  // namespace tumble::render
