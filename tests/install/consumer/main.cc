// consumer SCENE LOG: steps a scene, prints the hash of its last state, then the hash that the log has for that step.
#include <fstream>
#include <iostream>
#include <sstream>

#include "tumble/replay/log_reader.h"
#include "tumble/scenes/scene_file.h"
#include "tumble/sim/step.h"

// Arithmetic on the library's own types in this program's flags: its inline functions are compiled here too.
static double sum_of_heights(const tumble::sim::WorldState& state) {
  tumble::sim::Vec3 sum = tumble::sim::Vec3::Zero();
  for (std::size_t i = 0; i < state.bodies.position.size(); ++i) {
    const tumble::sim::Axes axes = tumble::sim::axes_of(state.bodies.orientation[i]);
    sum += tumble::sim::to_world(axes, state.bodies.position[i]) + tumble::sim::cross(axes[0], axes[1]);
  }
  return sum.z();
}

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  std::ifstream file(argv[1]);
  std::stringstream text;
  text << file.rdbuf();
  const auto scene = tumble::scenes::parse_scene(text.str(), argv[1]);
  if (!scene.ok()) {
    std::cerr << scene.error().message << '\n';
    return 2;
  }
  auto world = tumble::sim::create_world(*scene);
  if (!world.ok()) {
    std::cerr << world.error().message << '\n';
    return 4;
  }
  std::size_t next = 0;
  double heights = 0;
  while (world->state().step < scene->steps) {
    for (; next < scene->inputs.size() && scene->inputs[next].step == world->state().step + 1; ++next) {
      if (!tumble::sim::apply(*world, scene->inputs[next].command).ok()) return 4;
    }
    if (!tumble::sim::step(*world).ok()) return 4;
    heights += sum_of_heights(world->state());
  }
  std::cout << to_string(tumble::sim::state_hash(world->state().bodies)) << '\n';
  auto log = tumble::replay::LogReader::open(argv[2]);
  if (!log.ok()) {
    std::cerr << log.error().message << '\n';
    return 2;
  }
  const auto last = log->read_step(log->last_step());
  if (!last.ok()) {
    std::cerr << last.error().message << '\n';
    return 3;
  }
  std::cout << to_string((*last)->state_hash) << '\n';
  return heights == heights ? 0 : 1;
}
