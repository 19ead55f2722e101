#include "golden/suite/scene_hash.h"

#include <variant>

#include "replay/format/chain.h"
#include "tumble/replay/step_record.h"

namespace tumble::golden {
namespace {

void add(Hasher& hasher, const sim::Origin& origin) {
  hasher.add(std::uint64_t{static_cast<std::uint8_t>(origin.kind)});
  hasher.add(std::uint64_t{origin.table});
  hasher.add(std::uint64_t{origin.row});
  hasher.add(std::uint64_t{origin.column});
}

void add(Hasher& hasher, const sim::WorldDef& world) {
  hasher.add(std::uint64_t{static_cast<std::uint8_t>(world.method)});
  hasher.add(std::uint64_t{world.substeps});
  hasher.add(std::uint64_t{world.split_collisions});
  hasher.add(std::uint64_t{world.ground});
  hasher.add(std::uint64_t{world.freezing});
  for (const double value : {world.dt, world.gravity.x(), world.gravity.y(), world.gravity.z(), world.freeze_energy,
                             world.freeze_time, world.slip_speed, world.air_drag, world.ground_material.friction,
                             world.ground_material.friction_dynamic, world.ground_material.restitution}) {
    hasher.add(value + 0.0);  // −0.0 and 0.0 are the same scene
  }
}

}  // namespace

Hash128 scene_hash(const sim::SceneDef& scene) {
  Hasher hasher;
  add(hasher, scene.world);
  hasher.add(scene.steps);
  // A box is hashed as the input that would throw it in: a field added to boxes is then never forgotten here.
  replay::StepRecord record;
  for (const sim::BoxDef& box : scene.boxes) {
    record.inputs.emplace_back(sim::Throw{box});
    add(hasher, box.origin);
  }
  const Hash128 boxes = replay::chain_next({}, record);
  hasher.add(boxes.low);
  hasher.add(boxes.high);
  record.inputs.clear();
  for (const sim::TimedCommand& input : scene.inputs) {
    hasher.add(input.step);
    record.inputs.push_back(input.command);
  }
  const Hash128 inputs = replay::chain_next({}, record);
  hasher.add(inputs.low);
  hasher.add(inputs.high);
  return hasher.digest();
}

}  // namespace tumble::golden
