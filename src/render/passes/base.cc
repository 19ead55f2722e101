#include "src/render/passes/base.h"

#include <algorithm>
#include <array>
#include <string>

#include "src/render/passes/base_shaders.h"

namespace tumble::render {
namespace {

using sim::Vec3;

const Vec3 kHorizon = {0.52, 0.56, 0.61};
const Vec3 kZenith = {0.13, 0.18, 0.27};

constexpr int kMaterialsUnit = 0;
constexpr int kDepthMapUnit = 1;

// Half the width of a shadow's soft edge over the light's distance: a lamp a good half metre wide, 60 m away.
constexpr double kShadowSoftness = 0.003;
constexpr double kShadowOffsetTexels = 1.5;

// How far one sees, m: the scale of the scene from where the camera stands.
double sight(const Snapshot& snapshot) {
  return std::max(sim::length(snapshot.camera.target - snapshot.camera.position), 1.0);
}
constexpr double kFogStart = 2.5;     // of sight; all is fog at four times that
constexpr double kGroundExtent = 11;  // of sight: its rim is in the fog

}  // namespace

Result<BasePass> BasePass::create(const Gl& gl, int width, int height) {
  BasePass pass;
  Result<ShaderProgram> boxes = ShaderProgram::create(gl, "the base pass", std::string(kBoxAttributes) + kBaseVertices,
                                                      std::string(kBaseOutput) + kBaseFragments);
  if (!boxes.ok()) return boxes.error();
  pass.boxes_ = std::move(*boxes);
  const std::string solid = "#define SOLID\n";
  Result<ShaderProgram> solids = ShaderProgram::create(
      gl, "the base pass of solids", solid + kBoxAttributes + kBaseVertices, solid + kBaseOutput + kBaseFragments);
  if (!solids.ok()) return solids.error();
  pass.solids_ = std::move(*solids);
  Result<ShaderProgram> background =
      ShaderProgram::create(gl, "the background", kFullScreenVertices, std::string(kBaseOutput) + kBackgroundFragments);
  if (!background.ok()) return background.error();
  pass.background_ = std::move(*background);
  Result<RenderTarget> image = RenderTarget::create(gl, width, height, RenderTarget::Format::kBytesWithDepth);
  if (!image.ok()) return image.error();
  pass.image_ = std::move(*image);
  pass.empty_ = GlObject::make(gl, GlObject::Kind::kVertexArray);
  return pass;
}

void BasePass::set_uniforms(const Gl& gl, const Scene& scene, const ShaderProgram& program) const {
  const auto& [snapshot, camera, light, depth, materials, effects] = scene;
  const double distance = sim::length(snapshot.light.target - snapshot.light.position);
  const double map_texel = 2 * light.tangent_x * distance / depth.map().width();
  const auto set = [&](const char* name, auto value) { program.set(gl, name, value); };
  set("clip_from_world", camera.clip_from_world);
  set("light_from_world", light.clip_from_world);
  set("eye", camera.eye);
  set("right", camera.right);
  set("up", camera.up);
  set("forward", camera.forward);
  set("light_at", light.eye);
  set("horizon", kHorizon);
  set("shadow_offset", static_cast<float>(map_texel * kShadowOffsetTexels));
  set("shadow_radius", static_cast<float>(std::max(distance * kShadowSoftness, map_texel)));
  set("motion", effects.motion ? static_cast<float>(0.5 / camera.tangent_y) : 0.0F);
  set("focus", effects.dof ? static_cast<float>(snapshot.camera.focus) : 0.0F);
  set("blur", static_cast<float>(snapshot.camera.blur));
  set("fog_start", static_cast<float>(sight(snapshot) * kFogStart));
  set("texel_angle", static_cast<float>(2 * camera.tangent_y / image_.height()));
  set("with_shadow", effects.shadow ? 1 : 0);
  set("with_specular", effects.specular && !effects.vertex ? 1 : 0);
  set("per_vertex", effects.vertex ? 1 : 0);
  set("materials", kMaterialsUnit);
  set("depth_map", kDepthMapUnit);
}

void BasePass::draw_background(const Gl& gl, const Scene& scene) const {
  const auto set = [&](const char* name, auto value) { background_.set(gl, name, value); };
  background_.use(gl);
  set("right", Vec3(scene.camera.right * scene.camera.tangent_x));
  set("up", Vec3(scene.camera.up * scene.camera.tangent_y));
  set("forward", scene.camera.forward);
  background_.set(gl, "pixels", static_cast<float>(image_.width()), static_cast<float>(image_.height()));
  set("horizon", kHorizon);
  set("zenith", kZenith);
  set("focus", scene.effects.dof ? static_cast<float>(scene.snapshot.camera.focus) : 0.0F);
  set("blur", static_cast<float>(scene.snapshot.camera.blur));
  gl.DepthFunc(GL_LEQUAL);
  gl.DepthMask(GL_FALSE);
  draw_full_screen(gl, empty_);
}

void BasePass::draw(const Gl& gl, const Scene& scene, const BoxMesh& boxes, const SolidMeshes& solids,
                    BoxMesh& scratch) const {
  image_.bind(gl);
  const float farthest = 1;
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.DepthMask(GL_TRUE);
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  gl.ClearBufferfv(GL_DEPTH, 0, &farthest);
  scene.materials.bind_texture(gl, kMaterialsUnit);
  scene.depth.map().bind_texture(gl, kDepthMapUnit);
  boxes_.use(gl);
  set_uniforms(gl, scene, boxes_);
  boxes.draw(gl);
  if (scene.snapshot.ground) {
    const BoxInstance ground = ground_instance(scene.camera.eye, sight(scene.snapshot) * kGroundExtent);
    scratch.load(gl, std::span(&ground, 1));
    scratch.draw(gl);
  }
  if (!solids.empty()) {
    solids_.use(gl);
    set_uniforms(gl, scene, solids_);
    solids.draw(gl);
  }
  draw_background(gl, scene);
  if (scene.snapshot.markers.empty()) return;
  gl.Disable(GL_DEPTH_TEST);
  boxes_.use(gl);
  scratch.load(gl, instances_of(scene.snapshot.markers));
  scratch.draw(gl);
}

}  // namespace tumble::render
