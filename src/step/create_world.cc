// World::create belongs to the world, but a start with frozen bodies needs the phases to find what they touch; so it is
// defined on the layer that may use them.
#include <numeric>
#include <string>

#include "src/model/limits.h"
#include "src/solve/contact_memory.h"
#include "src/solve/update_freezing.h"
#include "src/world/edit_bodies.h"
#include "src/world/world.h"

namespace tumble::sim {
namespace {

Error bad_def(const std::string& what) { return bad_input("world: " + what); }

bool in(double value, double low, double high) { return value >= low && value <= high; }  // false for NaN

Status check_def(const WorldDef& def) {
  if (!in(def.dt, kDtMin, kDtMax)) return bad_def("dt must be " + std::to_string(kDtMin) + " … 1 s");
  if (def.substeps == 0 || def.substeps > kSubstepsMax) return bad_def("substeps must be 1 … 1024");
  for (const double g : {def.gravity.x(), def.gravity.y(), def.gravity.z()}) {
    if (!in(g, -kGravityMax, kGravityMax)) return bad_def("gravity must be finite and within ±10000 m/s²");
  }
  for (const double value :
       {def.freeze_energy, def.freeze_time, def.slip_speed, def.air_drag, def.ground_material.friction,
        def.ground_material.friction_dynamic, def.ground_material.restitution}) {
    if (!in(value, 0, 1e9)) return bad_def("freezing, slip, drag and material values must be finite and not negative");
  }
  return {};
}

}  // namespace

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
  if (scene.world.method == Method::kThesis) {
    find_first_contact_objects(*world);
  } else {
    find_first_contact_memory(*world);
  }
  return world;
}

}  // namespace tumble::sim
