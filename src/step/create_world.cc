#include <optional>
#include <string>

#include "src/step/first_contacts.h"
#include "src/world/body_check.h"
#include "src/world/edit_bodies.h"
#include "tumble/sim/limits.h"
#include "tumble/sim/step.h"

namespace tumble::sim {

Result<World> create_world(const SceneDef& scene) {
  if (Status ok = check_def(scene.world); !ok.ok()) return ok.error();
  if (scene.boxes.size() > kBodiesMax) return bad_input("scene: more than " + std::to_string(kBodiesMax) + " bodies");
  WorldState state;
  state.def = scene.world;
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    const BoxDef& box = scene.boxes[i];
    if (Status ok = check_box(box); !ok.ok()) return ok.error();
    if (i > 0 && box.id <= scene.boxes[i - 1].id) {
      return bad_input("body " + std::to_string(box.id) + ": ids must ascend and be unique");
    }
    insert_body(state, box);
  }
  Result<World> world = World::restore(std::move(state));
  if (!world.ok()) return world;
  find_first_contacts(world->mutable_state(), std::nullopt);
  return world;
}

}  // namespace tumble::sim
