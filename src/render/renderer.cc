#include "tumble/render/renderer.h"

#include <algorithm>
#include <ctime>
#include <utility>
#include <vector>

#include "src/render/gl/context.h"
#include "src/render/passes/base.h"
#include "src/render/passes/blur.h"
#include "src/render/passes/composite.h"
#include "src/render/passes/depth.h"
#include "src/render/passes/present.h"
#include "src/render/passes/shrink.h"
#include "src/render/passes/stage_image.h"
#include "src/render/scene/box_mesh.h"
#include "src/render/scene/materials.h"
#include "src/render/scene/solid_meshes.h"
#include "src/render/scene/view.h"

namespace tumble::render {
namespace {

constexpr std::array<std::pair<const char*, Stage>, 9> kStages = {{{"depth", Stage::kDepth},
                                                                   {"base", Stage::kBase},
                                                                   {"masks", Stage::kMasks},
                                                                   {"shrunk", Stage::kShrunk},
                                                                   {"hdr", Stage::kHdr},
                                                                   {"blur_x", Stage::kBlurX},
                                                                   {"blurred", Stage::kBlurred},
                                                                   {"glow", Stage::kGlow},
                                                                   {"final", Stage::kFinal}}};

// Texels along an edge of the depth map: about as fine as the picture that it shades.
int depth_map_size(int height) {
  int size = 512;
  while (size < 2 * height && size < 4096) size *= 2;
  return size;
}

}  // namespace

Result<Stage> parse_stage(const std::string& word) {
  std::string known;
  for (const auto& [name, stage] : kStages) {
    if (word == name) return stage;
    known += (known.empty() ? "" : ", ") + std::string(name);
  }
  return bad_input("--pass: found \"" + word + "\", wanted one of " + known);
}

struct Renderer::Parts {
  std::unique_ptr<Context> context;  // first, so that it goes last
  Settings settings;
  Materials materials;
  BoxMesh boxes, scratch;
  SolidMeshes solids;
  DepthPass depth;
  BasePass base;
  ShrinkPass shrink;
  BlurPass blur_x, blur_y;
  CompositePass composite;
  PresentPass present;
  bool measures = false;
  std::array<double, 6> seconds{};

  Status build();
  Status draw(const Snapshot& snapshot);
  template <class Pass>
  void timed(std::size_t pass, const Pass& run);
};

namespace {

template <class T>
Status keep(T& part, Result<T> made) {
  if (!made.ok()) return made.error();
  part = std::move(*made);
  return {};
}

}  // namespace

Status Renderer::Parts::build() {
  const Gl& gl = context->gl();
  const auto& [width, height, samples, effects] = settings;
  const int small_width = (width + 3) / 4, small_height = (height + 3) / 4;
  Status status = keep(materials, Materials::create(gl));
  if (status.ok()) status = keep(boxes, BoxMesh::create(gl));
  if (status.ok()) status = keep(scratch, BoxMesh::create(gl));
  if (status.ok()) status = keep(depth, DepthPass::create(gl, depth_map_size(height)));
  if (status.ok()) status = keep(base, BasePass::create(gl, width * samples, height * samples));
  if (status.ok()) status = keep(shrink, ShrinkPass::create(gl, width, height, samples));
  if (status.ok()) status = keep(blur_x, BlurPass::create(gl, small_width, small_height));
  if (status.ok()) status = keep(blur_y, BlurPass::create(gl, small_width, small_height));
  if (status.ok()) status = keep(composite, CompositePass::create(gl, width, height, samples));
  if (status.ok()) status = keep(present, PresentPass::create(gl));
  return status;
}

template <class Pass>
void Renderer::Parts::timed(std::size_t pass, const Pass& run) {
  if (!measures) return run();
  context->gl().Finish();
  const std::clock_t start = std::clock();
  run();
  context->gl().Finish();
  seconds[pass] = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

Status Renderer::Parts::draw(const Snapshot& snapshot) {
  const Gl& gl = context->gl();
  const View camera = camera_view(snapshot.camera, settings.width, settings.height);
  const View light = light_view(snapshot);
  boxes.load(gl, instances_of(snapshot.boxes, camera));
  if (Status ok = solids.load(gl, snapshot.boxes); !ok.ok()) return ok;
  timed(0, [&] { settings.effects.shadow ? depth.draw(gl, boxes, solids, light) : depth.clear(gl); });
  const BasePass::Scene scene = {snapshot, camera, light, depth, materials, settings.effects};
  timed(1, [&] { base.draw(gl, scene, boxes, solids, scratch); });
  timed(2, [&] { shrink.draw(gl, base.image()); });
  timed(3, [&] { blur_x.draw(gl, shrink.image(), false); });
  timed(4, [&] { blur_y.draw(gl, blur_x.image(), true); });
  timed(5, [&] { composite.draw(gl, base.image(), blur_y.image(), settings.effects.bloom); });
  return {};
}

Renderer::Renderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Renderer::~Renderer() = default;

const char* Renderer::backend_name() const { return parts_->context->backend_name(); }

const Settings& Renderer::settings() const { return parts_->settings; }
void Renderer::use(const Effects& effects) { parts_->settings.effects = effects; }
std::string Renderer::driver() const { return parts_->context->driver(); }
void Renderer::measure_passes(bool on) { parts_->measures = on; }
const std::array<double, 6>& Renderer::pass_seconds() const { return parts_->seconds; }

namespace {

Status check_settings(const Settings& settings) {
  const auto& [width, height, samples, effects] = settings;
  if (width < kSizeMin || height < kSizeMin || width > kSizeMax || height > kSizeMax) {
    return bad_input("picture size: found " + std::to_string(width) + "x" + std::to_string(height) + ", wanted " +
                     std::to_string(kSizeMin) + " to " + std::to_string(kSizeMax) + " pixels each way");
  }
  if (samples < 1 || samples > kSamplesMax) {
    return bad_input("samples: found " + std::to_string(samples) + ", wanted 1 to " + std::to_string(kSamplesMax));
  }
  return {};
}

}  // namespace

Result<std::unique_ptr<Renderer>> Renderer::create(const Settings& settings, Backend backend) {
  if (const Status ok = check_settings(settings); !ok.ok()) return ok.error();
  return create_with(settings, Context::open(backend));
}

Result<std::unique_ptr<Renderer>> Renderer::create_in_current(const Settings& settings, FindGlFunction find) {
  if (const Status ok = check_settings(settings); !ok.ok()) return ok.error();
  return create_with(settings, Context::current(find));
}

Result<std::unique_ptr<Renderer>> Renderer::create_with(const Settings& settings,
                                                        Result<std::unique_ptr<Context>> context) {
  if (!context.ok()) return context.error();
  const auto& [width, height, samples, effects] = settings;
  auto parts = std::make_unique<Parts>();
  parts->context = std::move(*context);
  parts->settings = settings;
  GLint limit = 0;
  parts->context->gl().GetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  if (std::max(width, height) * samples > limit) {
    return bad_input("picture size: " + std::to_string(width) + "x" + std::to_string(height) + " with " +
                     std::to_string(samples) + " samples is beyond the driver's " + std::to_string(limit) +
                     " pixels; draw with fewer samples");
  }
  const Status built = parts->build();
  if (!built.ok()) return built.error();
  return std::unique_ptr<Renderer>(new Renderer(std::move(parts)));
}

Status Renderer::show(const Snapshot& snapshot, const Target& target) {
  const Gl& gl = parts_->context->gl();
  if (Status ok = parts_->draw(snapshot); !ok.ok()) return ok;
  parts_->present.draw(gl, parts_->composite.image(), target);
  return check_gl(gl, "drawing");
}

Result<Image> Renderer::draw(const Snapshot& snapshot, Stage stage) {
  const Gl& gl = parts_->context->gl();
  if (const Status ok = parts_->draw(snapshot); !ok.ok()) return ok.error();
  Image image;
  switch (stage) {
    case Stage::kDepth:
      image = read_depth(gl, parts_->depth.map(), light_view(snapshot));
      break;
    case Stage::kBase:
      image = read_bytes(gl, parts_->base.image(), Channels::kColour);
      break;
    case Stage::kMasks:
      image = read_bytes(gl, parts_->base.image(), Channels::kAlpha);
      break;
    case Stage::kShrunk:
      image = read_floats(gl, parts_->shrink.image(), Channels::kColour);
      break;
    case Stage::kHdr:
      image = read_floats(gl, parts_->shrink.image(), Channels::kAlpha);
      break;
    case Stage::kBlurX:
      image = read_floats(gl, parts_->blur_x.image(), Channels::kColour);
      break;
    case Stage::kBlurred:
      image = read_floats(gl, parts_->blur_y.image(), Channels::kColour);
      break;
    case Stage::kGlow:
      image = read_floats(gl, parts_->blur_y.image(), Channels::kAlpha);
      break;
    case Stage::kFinal:
      image = read_bytes(gl, parts_->composite.image(), Channels::kColour);
      break;
  }
  const Status drawn = check_gl(gl, "drawing");
  if (!drawn.ok()) return drawn.error();
  return image;
}

}  // namespace tumble::render
