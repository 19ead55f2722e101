#include "src/render/passes/depth.h"

namespace tumble::render {
namespace {

const char* const kVertices = R"(
uniform mat4 clip_from_world;
void main() {
  vec3 at_B = corner * half_extent;
  vec3 at = centre + axis_x * at_B.x + axis_y * at_B.y + axis_z * at_B.z;
  gl_Position = clip_from_world * vec4(at, 1.0);
}
)";

const char* const kDepthFragments = "void main() {}\n";

}  // namespace

Result<DepthPass> DepthPass::create(const Gl& gl, int size) {
  DepthPass pass;
  Result<ShaderProgram> program =
      ShaderProgram::create(gl, "the depth pass", std::string(kBoxAttributes) + kVertices, kDepthFragments);
  if (!program.ok()) return program.error();
  pass.program_ = std::move(*program);
  Result<RenderTarget> map = RenderTarget::create(gl, size, size, RenderTarget::Format::kDepthOnly);
  if (!map.ok()) return map.error();
  pass.map_ = std::move(*map);
  return pass;
}

void DepthPass::clear(const Gl& gl) const {
  map_.bind(gl);
  const float farthest = 1;
  gl.DepthMask(GL_TRUE);
  gl.ClearBufferfv(GL_DEPTH, 0, &farthest);
}

void DepthPass::draw(const Gl& gl, const BoxMesh& boxes, const SolidMeshes& solids, const View& light) const {
  clear(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  program_.use(gl);
  program_.set(gl, "clip_from_world", light.clip_from_world);
  boxes.draw(gl);
  solids.draw(gl);
}

}  // namespace tumble::render
