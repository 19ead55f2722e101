// World::create belongs to the world, but a start with frozen bodies needs the phases to find what they touch; so it is
// defined on the layer that may use them.
#include <optional>
#include <string>

#include "src/model/limits.h"
#include "src/step/first_contacts.h"
#include "src/world/body_check.h"
#include "src/world/edit_bodies.h"
#include "src/world/world.h"

namespace tumble::sim {
Result<World> World::create(const SceneDef& scene) {
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
  Result<World> world = restore(std::move(state));
  if (!world.ok()) return world;
  find_first_contacts(*world, std::nullopt);
  return world;
}

}  // namespace tumble::sim
