#include "bench/thread_trials.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <utility>

#include "tumble/scenes/scene_file.h"

namespace tumble::bench {
namespace {

constexpr int kWarmSteps = 60;

}  // namespace

const std::vector<Trial>& trials() {
  static const std::string long_steps = "world.dt=0.03333333333333333", four = "world.substeps=4";
  static const std::vector<Trial> all = {
      {"6400", "tilted_grid", {"grid.rows=80", "grid.cols=80", long_steps, four}, 1.0 / 300, 1},
      {"25600", "tilted_grid", {"grid.rows=20", "grid.cols=1280", long_steps, four}, 1.0 / 300, 1},
      {"102400", "tilted_grid", {"grid.rows=20", "grid.cols=5120", long_steps, four}, 1.0 / 300, 1},
      {"pile", "pile", {"world.substeps=8", "world.freezing=false"}, 1.0 / 60, 8},
      {"large_pyramid", "large_pyramid", {}, 1.0 / 60, 1},
  };
  return all;
}

std::string trial_names() {
  std::string names;
  for (const Trial& trial : trials()) names += (names.empty() ? "" : ", ") + std::string(trial.name);
  return names;
}

void fail(const std::string& message) {
  std::fprintf(stderr, "thread_model: %s\n", message.c_str());
  std::exit(2);
}

void make_step(sim::World& world, sim::Observer* observer) {
  if (const Result<sim::StepCounters> done = sim::step(world, observer); !done.ok()) fail(done.error().message);
}

sim::WorldState warm_state(const Trial& trial) {
  const std::string path = std::string(TUMBLE_SOURCE_DIR "/bench/scenes/") + trial.scene + ".toml";
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const Result<sim::SceneDef> scene = scenes::parse_scene(text, path, trial.warm);
  if (!scene.ok()) fail(scene.error().message);
  Result<sim::World> world = sim::create_world(*scene);
  if (!world.ok()) fail(world.error().message);
  for (int k = 0; k < kWarmSteps; ++k) make_step(*world);
  sim::WorldState state = world->state();
  state.def.dt = trial.dt;
  state.def.substeps = trial.substeps;
  return state;
}

sim::World world_from(const sim::WorldState& state) {
  Result<sim::World> world = sim::World::restore(state);
  if (!world.ok()) fail(world.error().message);
  return std::move(*world);
}

}  // namespace tumble::bench
