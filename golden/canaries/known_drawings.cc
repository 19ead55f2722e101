#include <array>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "golden/canaries/known_answers.h"
#include "tumble/process/job_pool.h"
#include "tumble/render/backend.h"
#include "tumble/render/effects.h"
#include "tumble/render/renderer.h"
#include "tumble/sim/rotation.h"

namespace tumble::golden {
namespace {

constexpr int kWidth = 64, kHeight = 48;
constexpr int kLevels = 3;  // by which the mean of a quarter may differ with another version of the driver

struct Drawing {
  const char* name;
  render::Stage stage;
  const char* effects;
  std::array<int, 4> wanted;  // mean level of each quarter: top left and right, bottom left and right
};
constexpr std::array kDrawings = {
    Drawing{"distances from the light", render::Stage::kDepth, "all", {249, 244, 212, 253}},
    Drawing{"the boxes", render::Stage::kBase, "all", {173, 192, 161, 176}},
    Drawing{"masks of depth and motion", render::Stage::kMasks, "all", {230, 232, 96, 164}},
    Drawing{"the picture made small", render::Stage::kShrunk, "all", {174, 193, 164, 178}},
    Drawing{"the mask of bright places", render::Stage::kHdr, "all", {4, 16, 1, 4}},
    Drawing{"blur along x", render::Stage::kBlurX, "all", {175, 193, 166, 179}},
    Drawing{"blur", render::Stage::kBlurred, "all", {175, 194, 167, 180}},
    Drawing{"glow", render::Stage::kGlow, "all", {5, 15, 1, 4}},
    Drawing{"the picture", render::Stage::kFinal, "all", {177, 200, 162, 178}},
    Drawing{"no effect", render::Stage::kFinal, "none", {174, 194, 179, 201}},
    Drawing{"shadows alone", render::Stage::kFinal, "shadow", {174, 191, 162, 176}},
    Drawing{"all but bloom", render::Stage::kFinal, "-bloom", {175, 194, 161, 176}},
    Drawing{"light per vertex", render::Stage::kFinal, "vertex", {177, 197, 162, 178}},
};

render::Snapshot drawn_snapshot() {
  render::Snapshot s;
  s.camera = {{3, -6, 3}, {0, 0, 1}, 50, 6, 2};
  s.light = {{4, -2, 9}, {0, 0, 0}};
  for (std::uint64_t id = 1; id <= 5; ++id) {
    render::BoxLook& box = s.boxes.emplace_back();
    box.id = id;
    box.centre = {static_cast<double>(id) - 3, static_cast<double>(id * id % 5) - 2,
                  0.5 + 0.25 * static_cast<double>(id)};
    box.half_extent = {0.5, 0.25 * static_cast<double>(id), 0.5};
    box.orientation = sim::normalised({1, 0.125 * static_cast<double>(id), 0, 0.25});
    box.texture = static_cast<sim::Texture>(id % 5);
    box.velocity = {id == 3 ? 8.0 : 0.0, 0, 0};
  }
  s.boxes.back().tint = {4, 4, 4};
  render::Marker& marker = s.markers.emplace_back();
  marker.centre = {-1.5, -2, 0.5};
  marker.half_extent = {0.25, 0.25, 0.25};
  marker.colour = {1, 0, 0};
  return s;
}

std::array<int, 4> quarters(const render::Image& image) {
  std::array<double, 4> sum{};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::size_t quarter = (2 * y >= image.height ? 2U : 0U) + (2 * x >= image.width ? 1U : 0U);
      for (std::size_t k = 0; k < 3; ++k) sum[quarter] += image.rgb[image.at(x, y) + k];
    }
  }
  std::array<int, 4> means{};
  const double channels = 0.75 * image.width * image.height;
  for (std::size_t k = 0; k < 4; ++k) means[k] = static_cast<int>(std::lround(sum[k] / channels));
  return means;
}

// The ground's rim from high above, where the sky behind it is of another colour: the ground ends at eleven times the
// distance that one sees to, the picture shows ten to twelve times.
std::string rim_of_ground(render::Renderer& renderer) {
  render::Snapshot snapshot;
  snapshot.camera = {{0, 0, 8}, {0, 0.8, 7.4}, 5, 1, 0};
  snapshot.light = {{4, -2, 9}, {0, 0, 0}};
  renderer.use(*render::parse_effects("none"));
  const Result<render::Image> image = renderer.draw(snapshot, render::Stage::kBase);
  if (!image.ok()) return image.error().message;
  // From the top: the first row that is as the lowest one, which is ground.
  const auto level = [&](int y) { return static_cast<int>(image->rgb[image->at(image->width / 2, y)]); };
  int row = 0;
  while (row < image->height && std::abs(level(row) - level(image->height - 1)) > kLevels) ++row;
  return std::to_string(row);
}

std::string drawing_words() {
  std::string found;
  for (const char* list :
       {"all", "none", "shadow,bloom", "-dof,-motion", "vertex", "vertex,-shadow", "specular,-dof", "glow", ""}) {
    const Result<render::Effects> effects = render::parse_effects(list);
    found += (effects.ok() ? to_string(*effects) : effects.error().message) + "; ";
  }
  for (const char* word : {"depth", "base", "masks", "shrunk", "hdr", "blur_x", "blurred", "glow", "final", "last"}) {
    const Result<render::Stage> stage = render::parse_stage(word);
    found += (stage.ok() ? std::to_string(static_cast<int>(*stage)) : stage.error().message) + " ";
  }
  for (const char* word : {"auto", "osmesa", "egl", "glx"}) {
    const Result<render::Backend> backend = render::parse_backend(word);
    found += (backend.ok() ? std::to_string(static_cast<int>(*backend)) : backend.error().message) + " ";
  }
  for (const render::Settings& settings :
       {render::Settings{15, 48, 1, {}}, render::Settings{64, 4097, 1, {}}, render::Settings{64, 48, 5, {}}}) {
    const auto renderer = render::Renderer::create(settings);
    found += (renderer.ok() ? "drawn" : renderer.error().message) + "; ";
  }
  return found;
}

constexpr const char* kWords =
    "all; none; shadow,bloom; specular,shadow,bloom; specular,shadow,bloom,dof,motion,vertex; "
    "specular,bloom,dof,motion,vertex; --effects: found \"specular,-dof\", which both names and takes away; wanted "
    "all, none, or some of specular,shadow,bloom,dof,motion,vertex; with a - before each word, all but these; "
    "--effects: found \"glow\", which has the unknown word \"glow\"; wanted all, none, or some of "
    "specular,shadow,bloom,dof,motion,vertex; with a - before each word, all but these; --effects: found \"\", which "
    "has the unknown word \"\"; wanted all, none, or some of specular,shadow,bloom,dof,motion,vertex; with a - before "
    "each word, all but these; 0 1 2 3 4 5 6 7 8 --pass: found \"last\", wanted one of depth, base, masks, shrunk, "
    "hdr, blur_x, blurred, glow, final 0 1 2 --gl: found \"glx\", wanted auto, osmesa or egl picture size: found "
    "15x48, wanted 16 to 4096 pixels each way; picture size: found 64x4097, wanted 16 to 4096 pixels each way; "
    "samples: found 5, wanted 1 to 4; ";

constexpr int kRim = 16, kRimRows = 2;  // row of kHeight, and by how many another version of the driver may be off

// The drawings' means, a line each; "none" on a machine without OpenGL.
std::string draw_all() {
  const auto renderer = render::Renderer::create({kWidth, kHeight, 2, {}});
  if (!renderer.ok()) return "none";
  std::string lines;
  for (const Drawing& drawing : kDrawings) {
    (*renderer)->use(*render::parse_effects(drawing.effects));
    const Result<render::Image> image = (*renderer)->draw(drawn_snapshot(), drawing.stage);
    if (!image.ok()) return image.error().message;
    for (const int mean : quarters(*image)) lines += std::to_string(mean) + " ";
  }
  return lines;
}

std::string draw_rim() {
  const auto renderer = render::Renderer::create({kWidth, kHeight, 1, {}});
  return renderer.ok() ? rim_of_ground(**renderer) : "none";
}

// The lines of the depth map of pictures of few lines, of some and of the most.
std::string map_sizes() {
  std::string found;
  for (const int height : {kHeight, 1024, 4096}) {
    const auto renderer = render::Renderer::create({16, height, 1, {}});
    if (!renderer.ok()) return "none";
    const Result<render::Image> map = (*renderer)->draw(drawn_snapshot(), render::Stage::kDepth);
    found += (map.ok() ? std::to_string(map->height) : map.error().message) + " ";
  }
  return found;
}

bool brightness_alike(const std::string& line) {
  std::istringstream numbers(line);
  for (const Drawing& drawing : kDrawings) {
    for (const int wanted : drawing.wanted) {
      int found = 0;
      if (!(numbers >> found) || std::abs(found - wanted) > kLevels) return false;
    }
  }
  return true;
}

// In a process of its own: the driver draws by threads, and later canaries fork. fits: of what it drew.
CanaryResult drawn_apart(std::string (*draw)(), bool (*fits)(const std::string& drawn)) {
  CanaryResult result;
  process::run_jobs(
      1, [draw](std::size_t) { return draw(); },
      [&](std::size_t, const process::JobResult& child) {
        if (child.output == "none") {
          result = not_asked("this machine has no OpenGL");
          return;
        }
        result.caught = child.failure.empty() && fits(child.output);
        result.message = result.caught ? "as known" : child.failure + child.output;
      },
      {});
  return result;
}

bool maps_alike(const std::string& sizes) { return sizes == "512 2048 4096 "; }
bool rim_alike(const std::string& row) { return std::abs(std::atoi(row.c_str()) - kRim) <= kRimRows; }

}  // namespace

void run_known_drawings(CanaryRoll& roll) {
  roll.known("words for effects, stages and sizes are read as they were", drawing_words, kWords);
  roll.ask("stages, effects and markers are as bright as they were",
           [] { return drawn_apart(draw_all, brightness_alike); });
  roll.ask("shadows are as fine as the picture", [] { return drawn_apart(map_sizes, maps_alike); });
  roll.ask("the ground ends where it ended", [] { return drawn_apart(draw_rim, rim_alike); });
}

}  // namespace tumble::golden
