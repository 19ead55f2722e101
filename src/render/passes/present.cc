#include "src/render/passes/present.h"

namespace tumble::render {
namespace {

// k / 255 is the value that every driver stores as the byte k, so the window shows the picture's own bytes.
const char* const kPresentFragments = R"(
uniform usampler2D picture;
uniform vec2 corner, scale;
uniform ivec2 last;
out vec4 shown;
void main() {
  ivec2 from = clamp(ivec2((gl_FragCoord.xy - corner) * scale), ivec2(0), last);
  shown = vec4(vec3(texelFetch(picture, from, 0).rgb) * (1.0 / 255.0), 1.0);
}
)";

}  // namespace

Result<PresentPass> PresentPass::create(const Gl& gl) {
  PresentPass pass;
  Result<ShaderProgram> program =
      ShaderProgram::create(gl, "the copy to the window", kFullScreenVertices, kPresentFragments);
  if (!program.ok()) return program.error();
  pass.program_ = std::move(*program);
  pass.empty_ = GlObject::make(gl, GlObject::Kind::kVertexArray);
  return pass;
}

void PresentPass::draw(const Gl& gl, const RenderTarget& picture, const Target& target) const {
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  gl.Viewport(target.x, target.y, target.width, target.height);
  gl.Disable(GL_DEPTH_TEST);
  picture.bind_texture(gl, 0);
  program_.use(gl);
  program_.set(gl, "picture", 0);
  program_.set(gl, "corner", static_cast<float>(target.x), static_cast<float>(target.y));
  program_.set(gl, "scale", static_cast<float>(picture.width()) / static_cast<float>(target.width),
               static_cast<float>(picture.height()) / static_cast<float>(target.height));
  program_.set(gl, "last", picture.width() - 1, picture.height() - 1);
  draw_full_screen(gl, empty_);
}

}  // namespace tumble::render
