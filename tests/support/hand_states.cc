#include "tests/support/hand_states.h"

namespace tumble::replay {

BoxDef box(sim::BodyId id, const sim::Vec3& position) {
  BoxDef def;
  def.id = id;
  def.position = position;
  return def;
}

BodyStates states_of(const std::vector<BoxDef>& boxes) {
  BodyStates states;
  for (const BoxDef& def : boxes) {
    states.id.push_back(def.id);
    states.position.push_back(def.position);
    states.velocity.push_back(def.velocity);
    states.spin.push_back(def.spin);
    states.orientation.insert(states.orientation.size(), def.orientation);
    states.frozen.push_back(def.frozen ? 1 : 0);
  }
  return states;
}

sim::SceneDef scene_of(const std::vector<BoxDef>& boxes) {
  sim::SceneDef scene;
  scene.world.method = sim::Method::kThesis;
  scene.boxes = boxes;
  scene.world.gravity = {0, 0, -10};
  return scene;
}

StepRecord step_record(std::uint64_t step, const std::vector<BoxDef>& boxes, double kinetic, double potential,
                       double inputs, double removed) {
  StepRecord record;
  record.step = step;
  record.dt = 0.25;
  record.counters.kinetic = kinetic;
  record.counters.potential = potential;
  record.counters.inputs = inputs;
  record.counters.removed = removed;
  record.has_states = true;
  record.states = states_of(boxes);
  return record;
}

}  // namespace tumble::replay
