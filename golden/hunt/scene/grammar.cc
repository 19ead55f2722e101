#include "golden/hunt/scene/grammar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "golden/hunt/scene/arrangements.h"
#include "golden/hunt/scene/draws.h"

namespace tumble::hunt {
namespace {

using sim::Vec3;

struct Kind {
  const char* name;
  Arrange arrange;
  unsigned share;  // of all scenes, in parts of the sum
};
constexpr std::array kKinds = {
    Kind{"stack", arrange_stack, 10},      Kind{"wall", arrange_wall, 4},
    Kind{"heap", arrange_heap, 16},        Kind{"throw", arrange_throw, 10},
    Kind{"slope", arrange_slope, 12},      Kind{"spinners", arrange_spinners, 12},
    Kind{"ratios", arrange_ratios, 10},    Kind{"flight", arrange_flight, 4},
    Kind{"ties", arrange_ties, 10},        Kind{"collisions", arrange_collisions, 10},
    Kind{"overlaps", arrange_overlaps, 6}, Kind{"drop", arrange_drop, 4},
};

constexpr std::uint64_t kGravityDraw = std::uint64_t{1} << 32U;

const Kind& any_kind(Draws& draws) {
  unsigned sum = 0;
  for (const Kind& kind : kKinds) sum += kind.share;
  std::uint64_t left = draws.below(sum);
  for (const Kind& kind : kKinds) {
    if (left < kind.share) return kind;
    left -= kind.share;
  }
  return kKinds.back();
}

void choose_world(sim::WorldDef& world, Draws& draws) {
  world.method = draws.chance(0.6) ? sim::Method::kLayered : sim::Method::kThesis;
  world.dt = draws.chance(0.4) ? 1.0 / 60 : draws.chance(0.5) ? draws.uniform(0.002, 0.034) : draws.magnitude(-10, -4);
  const std::array<std::uint32_t, 6> substeps = {1, 2, 4, 8, 8, 3};
  world.substeps = substeps[draws.below(substeps.size())];
  world.freezing = draws.chance(0.7);
  if (draws.chance(0.3)) world.freeze_time = draws.uniform(0.05, 0.3);
  if (draws.chance(0.1)) world.air_drag = draws.uniform(0, 0.5);
  world.ground_material.friction = draws.chance(0.2) ? 0 : draws.uniform(0, 1);
  world.ground_material.friction_dynamic =
      draws.chance(0.5) ? world.ground_material.friction : draws.uniform(0, world.ground_material.friction);
  world.ground_material.restitution = draws.chance(0.4) ? 0 : draws.chance(0.1) ? 1 : draws.uniform(0, 0.9);
}

// In some scenes gravity is weaker, down to 4 mm/s², or there is none. Drawn far from the other numbers, so that the
// rest of the scene is that of grammar 1.
void choose_gravity(sim::WorldDef& world, Draws draws) {
  if (!draws.chance(0.08)) return;
  world.gravity *= draws.chance(0.2) ? 0 : draws.magnitude(-11, 0);
}

sim::Command any_input(const sim::SceneDef& scene, Draws& draws, sim::BodyId body, double mass) {
  switch (draws.below(6)) {
    case 0:
      return sim::Wake{body};
    case 1: {
      const Vec3 velocity = draws.vector(5);
      return sim::SetVelocity{body, velocity, draws.vector(5)};
    }
    case 2:
      return sim::SetGravity{scene.world.gravity + draws.vector(2)};
    case 3:
      return sim::SetDt{scene.world.dt * draws.uniform(0.5, 1.2)};
    default:
      return sim::Push{body, draws.vector(3) * mass, true, {0, 0, 0}};
  }
}

// Inputs at any step; one of them may remove a body that no later one names.
void add_inputs(sim::SceneDef& scene, Draws& draws) {
  for (std::uint64_t count = draws.below(4); count > 0; --count) {
    const sim::BoxDef& box = scene.boxes[draws.below(scene.boxes.size())];
    if (box.is_static) continue;
    const std::uint64_t step = 1 + draws.below(scene.steps);
    scene.inputs.push_back({step, any_input(scene, draws, box.id, box.mass)});
  }
  if (scene.boxes.size() > 2 && draws.chance(0.2)) {
    const sim::BodyId gone = scene.boxes[draws.below(scene.boxes.size())].id;
    const std::uint64_t last = scene.steps;
    scene.inputs.push_back({last - draws.below(last / 2 + 1), sim::Remove{gone}});
    const std::uint64_t when = scene.inputs.back().step;
    for (sim::TimedCommand& input : scene.inputs) {
      if (!std::holds_alternative<sim::Remove>(input.command)) input.step = std::min(input.step, when);
    }
  }
  std::ranges::stable_sort(scene.inputs, {}, &sim::TimedCommand::step);
}

// A material of their own for some bodies, and for some scenes one static body.
void vary_bodies(sim::SceneDef& scene, Draws& draws) {
  if (draws.chance(0.7)) return;
  for (sim::BoxDef& box : scene.boxes) {
    if (draws.chance(0.5)) continue;
    box.material.friction = draws.uniform(0, 1);
    box.material.friction_dynamic = draws.uniform(0, box.material.friction);
    box.material.restitution = draws.uniform(0, 0.9);
  }
}

// Ids that are no row numbers.
void name_bodies(sim::SceneDef& scene, Draws& draws) {
  const std::uint64_t gap = draws.chance(0.5) ? 1 : 1 + draws.below(9);
  const auto named = [gap](sim::BodyId id) { return 1 + gap * (id - 1); };
  for (sim::BoxDef& box : scene.boxes) box.id = named(box.id);
  for (sim::TimedCommand& input : scene.inputs) {
    if (auto* thrown = std::get_if<sim::Throw>(&input.command)) thrown->box.id = named(thrown->box.id);
  }
}

}  // namespace

sim::SceneDef random_scene(std::uint64_t seed, std::uint64_t number) {
  Draws draws(seed, number);
  sim::SceneDef scene;
  choose_world(scene.world, draws);
  const Kind& kind = any_kind(draws);
  scene.name = "hunt_" + std::to_string(seed) + "_" + std::to_string(number);
  scene.title = std::string(kind.name) + ", scene " + std::to_string(number) + " of seed " + std::to_string(seed);
  scene.category = "session";
  kind.arrange(scene, draws);
  const double seconds = draws.uniform(0.3, 2);
  scene.steps = std::clamp<std::uint64_t>(static_cast<std::uint64_t>(seconds / scene.world.dt), 30, kStepsMost);
  choose_gravity(scene.world, Draws(seed, number, kGravityDraw));
  vary_bodies(scene, draws);
  name_bodies(scene, draws);
  if (draws.chance(0.4)) add_inputs(scene, draws);
  return scene;
}

}  // namespace tumble::hunt
