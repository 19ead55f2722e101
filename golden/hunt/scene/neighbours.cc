#include "golden/hunt/scene/neighbours.h"

#include <algorithm>
#include <cmath>

namespace tumble::hunt {
namespace {

using sim::Vec3;

constexpr double kApart = 4096;                     // m
constexpr double kFarthest = 30000;                 // m, of the 32768 that a world has
constexpr sim::BodyId kFirstId = 9007199254740000;  // the highest are hardly ever taken
constexpr std::uint32_t kStoreys = 12;

}  // namespace

std::optional<Neighboured> with_neighbours(const sim::SceneDef& scene) {
  Neighboured out = {scene, kApart};
  const auto make_room = [&](const sim::BoxDef& box) {
    out.where = std::max(out.where, std::ceil(box.position.x()) + kApart);
    return box.id < kFirstId;
  };
  bool free_ids = std::ranges::all_of(scene.boxes, make_room);
  for (const sim::TimedCommand& input : scene.inputs) {
    if (const auto* const thrown = std::get_if<sim::Throw>(&input.command)) free_ids &= make_room(thrown->box);
  }
  if (!free_ids || out.where > kFarthest) return std::nullopt;
  sim::BodyId id = kFirstId;
  const auto add = [&](const Vec3& at, const Vec3& size, double mass, const Vec3& velocity = Vec3::Zero()) {
    sim::BoxDef box;
    box.id = id++;
    box.position = Vec3(out.where, 0, 0) + at;
    box.size = size;
    box.mass = mass;
    box.velocity = velocity;
    out.scene.boxes.push_back(box);
  };
  for (std::uint32_t k = 0; k < kStoreys; ++k) add({0.01 * (k % 3), 0, 0.5 + k}, {1, 1, 1}, 1);
  add({30, 0, 1.5}, {0.05, 0.05, 3}, 1);
  add({30, 0, 3.6}, {1, 1, 1}, 1e6, {0, 0, -2});
  add({60, 0, 0.5}, {1, 1, 1}, 1);
  add({60, 0, 1.4}, {1, 1, 1}, 1);
  add({90, 0, 1}, {0.05, 0.05, 0.05}, 0.01, {400, 0, 0});
  add({93, 0, 1}, {0.05, 2, 2}, 5);
  return out;
}

}  // namespace tumble::hunt
