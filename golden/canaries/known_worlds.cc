#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "golden/canaries/canary_roll.h"
#include "golden/canaries/known_answers.h"
#include "src/base/text.h"
#include "src/model/camera.h"
#include "src/world/memory_use.h"
#include "tumble/sim/step.h"

namespace tumble::golden {
namespace {

using sim::Vec3;
using sim::World;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Scenes that no file can hold, since the reader of scenes refuses them: from a log, or by another program.
const std::vector<WrongValue<sim::SceneDef>>& wrong_scenes() {
  static const std::vector<WrongValue<sim::SceneDef>> kWrongScenes = {
      {"as it must be", [](auto&) {}, "taken"},
      {"two ids alike", [](auto& s) { s.boxes[1].id = 1; }, "body 1: ids must ascend and be unique"},
      {"ids descend", [](auto& s) { s.boxes[2].id = 1; }, "body 1: ids must ascend and be unique"},
      {"id 0", [](auto& s) { s.boxes[0].id = 0; }, "body 0: found this id, wanted 1 … 2^53 − 1"},
      {"id 2^53", [](auto& s) { s.boxes[2].id = 1ULL << 53U; },
       "body 9007199254740992: found this id, wanted 1 … 2^53 − 1"},
      {"an edge too short", [](auto& s) { s.boxes[0].size.y() = 0.9e-4; },
       "body 1: found an edge of 9e-05 m, wanted 0.0001 … 4096 m"},
      {"an edge too long", [](auto& s) { s.boxes[0].size.z() = 4097; },
       "body 1: found an edge of 4097 m, wanted 0.0001 … 4096 m"},
      {"the longest edge", [](auto& s) { s.boxes[0].size.z() = 4096; }, "taken"},
      {"no mass", [](auto& s) { s.boxes[0].mass = 0; }, "body 1: found a mass of 0 kg, wanted 1e-09 … 1e+12 kg"},
      {"a mass too great", [](auto& s) { s.boxes[0].mass = 1.1e12; },
       "body 1: found a mass of 1.1e+12 kg, wanted 1e-09 … 1e+12 kg"},
      {"the least mass", [](auto& s) { s.boxes[0].mass = 1e-9; }, "taken"},
      {"a position beyond", [](auto& s) { s.boxes[0].position.x() = 32769; },
       "body 1: found position (32769, 0, 0.5) m, wanted finite and within ±32768 m"},
      {"a position that is no number", [](auto& s) { s.boxes[0].position.z() = kNone; },
       "body 1: found position (0, 0, nan) m, wanted finite and within ±32768 m"},
      {"a velocity beyond", [](auto& s) { s.boxes[1].velocity.y() = -8193; },
       "body 2: found velocity (0, -8193, 0) m/s, wanted finite and within ±8192 m/s"},
      {"a spin beyond", [](auto& s) { s.boxes[1].spin.z() = 8193; },
       "body 2: found spin (0, 0, 8193) rad/s, wanted finite and within ±8192 rad/s"},
      {"no orientation",
       [](auto& s) {
         s.boxes[1].orientation = {0, 0, 0, 0};
       },
       "body 2: its orientation has no direction; use [1, 0, 0, 0]"},
      {"friction below 0", [](auto& s) { s.boxes[1].material.friction = -0.1; },
       "body 2: found a material of friction -0.1, dynamic 0.4, and restitution 0.2, wanted friction 0 … 1000 and "
       "restitution 0 … 1"},
      {"friction above 1000", [](auto& s) { s.boxes[1].material.friction_dynamic = 1001; },
       "body 2: found a material of friction 0.4, dynamic 1001, and restitution 0.2, wanted friction 0 … 1000 and "
       "restitution 0 … 1"},
      {"restitution above 1", [](auto& s) { s.boxes[1].material.restitution = 1.1; },
       "body 2: found a material of friction 0.4, dynamic 0.4, and restitution 1.1, wanted friction 0 … 1000 and "
       "restitution 0 … 1"},
      {"no dt", [](auto& s) { s.world.dt = 0; }, "world: found a dt of 0 s, wanted 1e-07 … 1 s"},
      {"no substeps", [](auto& s) { s.world.substeps = 0; }, "world: found 0 substeps, wanted 1 … 1024"},
      {"too many substeps", [](auto& s) { s.world.substeps = 1025; }, "world: found 1025 substeps, wanted 1 … 1024"},
      {"gravity beyond", [](auto& s) { s.world.gravity.x() = 10001; },
       "world: found a gravity of 10001 m/s² along an axis, wanted -10000 … 10000"},
      {"a time below 0", [](auto& s) { s.world.freeze_time = -1; }, "world: found a freeze_time of -1, wanted 0 … 1e9"},
      {"a method that is none", [](auto& s) { s.world.method = static_cast<sim::Method>(7); },
       "world: found method number 7, wanted thesis or layered"},
      {"a ground of no friction", [](auto& s) { s.world.ground_material.friction = kNone; },
       "world: ground: found a material of friction nan, dynamic 0.4, and restitution 0.2, wanted friction 0 … 1000 "
       "and "
       "restitution 0 … 1"},
  };
  return kWrongScenes;
}

struct WrongInput {
  const char* name;
  sim::Command command;
  const char* message;
};

sim::BoxDef thrown_box(sim::BodyId id) {
  sim::BoxDef box;
  box.id = id;
  box.position = {9, 9, 9};
  return box;
}

const std::vector<WrongInput>& wrong_inputs() {
  static const std::vector<WrongInput> kWrongInputs = {
      {"throw", sim::Throw{thrown_box(9)}, "taken"},
      {"throw of an id that is taken", sim::Throw{thrown_box(2)}, "throw: found id 2 twice, wanted a new one"},
      {"throw of id 0", sim::Throw{thrown_box(0)}, "body 0: found this id, wanted 1 … 2^53 − 1"},
      {"push", sim::Push{2, {1, 0, 0}, true, {0, 0, 0}}, "taken"},
      {"push of nobody", sim::Push{8, {1, 0, 0}, true, {0, 0, 0}},
       "push: found id 8, wanted the id of a body that exists at this step"},
      {"push of a static body", sim::Push{3, {1, 0, 0}, true, {0, 0, 0}}, "push: body 3 is static"},
      {"push that is no number", sim::Push{2, {kNone, 0, 0}, true, {0, 0, 0}},
       "push: found an impulse that is not finite or beyond ±1e+12, wanted one within"},
      {"push at a point beyond", sim::Push{2, {1, 0, 0}, false, {0, 32769, 0}},
       "push: found a point that is not finite or beyond ±32768, wanted one within"},
      {"push beyond all speeds", sim::Push{2, {9000, 0, 0}, true, {0, 0, 0}},
       "push: the impulse would take body 2 past 8192 m/s or rad/s; push less"},
      {"a weak push of a body that sleeps", sim::Push{1, {0.01, 0, 0}, false, {0, 0.5, 0.5}}, "taken"},
      {"remove of nobody", sim::Remove{8}, "remove: found id 8, wanted the id of a body that exists at this step"},
      {"wake of nobody", sim::Wake{8}, "wake: found id 8, wanted the id of a body that exists at this step"},
      {"set_velocity of nobody", sim::SetVelocity{8, {0, 0, 0}, {0, 0, 0}},
       "set_velocity: found id 8, wanted the id of a body that exists at this step"},
      {"set_velocity of a static body", sim::SetVelocity{3, {0, 0, 0}, {0, 0, 0}}, "set_velocity: body 3 is static"},
      {"set_velocity beyond", sim::SetVelocity{2, {8193, 0, 0}, {0, 0, 0}},
       "set_velocity: found a velocity that is not finite or beyond ±8192, wanted one within"},
      {"set_velocity with a spin beyond", sim::SetVelocity{2, {0, 0, 0}, {0, 8193, 0}},
       "set_velocity: found a spin that is not finite or beyond ±8192, wanted one within"},
      {"set_gravity beyond", sim::SetGravity{{0, 0, -10001}},
       "set_gravity: found a gravity that is not finite or beyond ±10000, wanted one within"},
      {"set_dt of 0", sim::SetDt{0}, "set_dt: found 0 s, wanted 1e-07 … 1 s"},
      {"set_dt of 2", sim::SetDt{2}, "set_dt: found 2 s, wanted 1e-07 … 1 s"},
  };
  return kWrongInputs;
}

const std::vector<WrongValue<sim::Camera>>& wrong_cameras() {
  static const std::vector<WrongValue<sim::Camera>> kWrongCameras = {
      {"as it must be", [](auto&) {}, "taken"},
      {"a position beyond", [](auto& c) { c.position.y() = 1.1e6; },
       "camera position: found 0, 1100000, 2, wanted three coordinates up to 1e6 m"},
      {"a target that is no number", [](auto& c) { c.target.x() = kNone; },
       "camera target: found nan, 0, 1, wanted three coordinates up to 1e6 m"},
      {"a target where the eye is", [](auto& c) { c.target = c.position; },
       "camera position: found the target's, wanted two points, or there is no direction to look in"},
      {"an angle too small", [](auto& c) { c.fov = 0.5; }, "camera fov: found 0.5, wanted a number from 1 to 170"},
      {"a focus too near", [](auto& c) { c.focus = 0; },
       "camera focus: found 0, wanted a number from 0.001 to 1000000"},
      {"a blur below 0", [](auto& c) { c.blur = -1; }, "camera blur: found -1, wanted a number from 0 to 100"},
  };
  return kWrongCameras;
}

// A copy of a world goes its own way, and both go the same one.
std::string world_copied() {
  Result<World> world = sim::create_world(three_crates(sim::Method::kLayered));
  if (!world.ok()) return world.error().message;
  if (const auto taken = sim::step(*world); !taken.ok()) return taken.error().message;
  World copy = *world, other = copy;
  if (const Status ok = sim::apply(copy, sim::Remove{2}); !ok.ok()) return ok.error().message;
  other = *world;
  for (World* each : {&*world, &other}) {
    for (int k = 0; k < 30; ++k) {
      if (const auto taken = sim::step(*each); !taken.ok()) return taken.error().message;
    }
  }
  const auto& a = world->bodies();
  const auto& b = other.bodies();
  const bool alike = a.position.z == b.position.z && a.velocity.z == b.velocity.z && a.spin.x == b.spin.x;
  return std::to_string(copy.bodies().size()) + " of " + std::to_string(a.size()) + (alike ? ", alike" : ", unlike");
}

// A world says what it holds: of twice the bodies about twice as much, and none of it twice.
std::string memory_held() {
  std::string found;
  for (const sim::Method method : {sim::Method::kThesis, sim::Method::kLayered}) {
    std::array<double, 2> per_body{};
    for (std::uint64_t k = 0; k < 2; ++k) {
      sim::SceneDef scene = three_crates(method);
      const std::uint64_t count = std::uint64_t{200} << k;
      for (std::uint64_t id = 4; id <= count; ++id) {
        scene.boxes.push_back(scene.boxes[1]);
        scene.boxes.back().id = id;
        scene.boxes.back().position = {3.0 * static_cast<double>(id), 0, 0.5};
      }
      Result<World> world = sim::create_world(scene);
      if (!world.ok()) return world.error().message;
      if (const auto taken = sim::step(*world); !taken.ok()) return taken.error().message;
      double bytes = 0;
      for (const sim::MemoryPart& part : sim::memory_use(*world)) bytes += static_cast<double>(part.bytes);
      per_body[k] = bytes / static_cast<double>(count);
    }
    const bool likely =
        per_body[0] > 500 && per_body[0] < 6000 && per_body[1] > 0.5 * per_body[0] && per_body[1] < 2 * per_body[0];
    found += likely ? "likely " : exact(per_body[0]) + " and " + exact(per_body[1]) + " bytes a body ";
  }
  return found;
}

std::string inputs_refused() {
  Result<World> world = sim::create_world(three_crates(sim::Method::kLayered));
  if (!world.ok() || !sim::step(*world).ok()) return "no world: " + status_text(status_of(world));
  for (const WrongInput& input : wrong_inputs()) {
    World copy = *world;
    const std::string found = status_text(sim::apply(copy, input.command));
    if (found != input.message) return std::string(input.name) + ": " + found;
  }
  return "as known";
}

}  // namespace

void run_known_worlds(CanaryRoll& roll) {
  roll.known("scenes that no file can hold are refused", [] {
    return ask_all(wrong_scenes(), three_crates(sim::Method::kThesis),
                   [](const auto& scene) { return status_of(sim::create_world(scene)); });
  });
  roll.known("inputs that cannot be are refused", inputs_refused);
  roll.known("cameras that see nothing are refused", [] {
    return ask_all(wrong_cameras(), sim::Camera{{0, -9, 2}, {0, 0, 1}, 50, 9, 1}, sim::check_camera);
  });
  roll.known("a copy of a world goes its own way", world_copied, "2 of 3, alike");
  roll.known("a world says how much memory it holds", memory_held, "likely likely ");
}

}  // namespace tumble::golden
