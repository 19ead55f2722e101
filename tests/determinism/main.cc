// Runs scenes and prints what they end in, one line each: name, steps, final hash; those of method layered in every
// lane width that the build and the machine have, and all split over threads: 3 all the way, 2, 4, 7 and 16 for the
// last steps, as an emulator takes long to wake so many so often. Needs only the simulation and the scene reader, so
// that it builds for machines on which the log's libraries are not installed (tools/scripts/checks/determinism.sh).
// Usage: determinism [--one-lane] SCENE.toml:STEPS...   --one-lane: compare nothing
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "src/kernels/kernels_by_width.h"
#include "src/world/scratch.h"
#include "tumble/scenes/scene_file.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/step.h"
#include "tumble/sim/world.h"
#include "tumble/threads/worker_threads.h"

namespace tumble {
namespace {

constexpr std::uint64_t kLastSteps = 6;  // that every number of threads makes

Status step_to(sim::World& world, const sim::SceneDef& scene, std::uint64_t last) {
  for (std::uint64_t k = world.state().step + 1; k <= last; ++k) {
    for (const auto& input : scene.inputs) {
      if (input.step != k) continue;
      if (Status applied = sim::apply(world, input.command); !applied) return applied;
    }
    if (Result<sim::StepCounters> counters = sim::step(world); !counters) return counters.error();
  }
  return {};
}

Result<sim::World> world_at(const sim::SceneDef& scene, std::uint64_t step, sim::LaneWidth lanes,
                            Workers* workers = nullptr) {
  Result<sim::World> world = sim::create_world(scene);
  if (!world) return world;
  world->mutable_scratch().lanes = lanes;
  world->use(workers);
  if (Status done = step_to(*world, scene, step); !done) return done.error();
  return world;
}

Result<Hash128> final_hash(const sim::SceneDef& scene, std::uint64_t steps, sim::LaneWidth lanes,
                           Workers* workers = nullptr) {
  const Result<sim::World> world = world_at(scene, steps, lanes, workers);
  if (!world) return world.error();
  return sim::state_hash(world->bodies());
}

Result<Hash128> final_hash(sim::World before, const sim::SceneDef& scene, std::uint64_t steps, Workers& workers) {
  before.use(&workers);
  if (Status done = step_to(before, scene, steps); !done) return done.error();
  return sim::state_hash(before.bodies());
}

Status must_equal(const sim::SceneDef& scene, const Hash128& one, const Result<Hash128>& other,
                  const std::string& how) {
  if (!other) return other.error();
  if (*other == one) return {};
  return cannot_finish(scene.name + ": " + how + " end in " + to_string(*other) + ", one lane and one thread in " +
                       to_string(one));
}

Status same_in_lanes(const sim::SceneDef& scene, std::uint64_t steps, const Hash128& hash) {
  for (const sim::LaneWidth lanes : {sim::LaneWidth::kTwo, sim::LaneWidth::kFour, sim::LaneWidth::kEight}) {
    if (!sim::runs_lanes(lanes)) continue;
    const std::string how = std::string(sim::name_of(lanes)) + " lanes";
    if (Status same = must_equal(scene, hash, final_hash(scene, steps, lanes), how); !same) return same;
  }
  return {};
}

// Everything is split, however small.
Status same_in_threads(const sim::SceneDef& scene, std::uint64_t steps, const Hash128& hash) {
  const std::uint64_t first = steps - std::min(steps, kLastSteps);
  const Result<sim::World> before = world_at(scene, first, sim::LaneWidth::kWidest);
  if (!before) return before.error();
  for (const unsigned count : {2U, 3U, 4U, 7U, 16U}) {
    WorkerThreads threads(count, Split::kEverything);
    if (threads.count() != count) return cannot_finish("no " + std::to_string(count) + " threads to be had");
    const Result<Hash128> split = count == 3 ? final_hash(scene, steps, sim::LaneWidth::kWidest, &threads)
                                             : final_hash(*before, scene, steps, threads);
    if (Status same = must_equal(scene, hash, split, std::to_string(count) + " threads"); !same) return same;
  }
  return {};
}

// The hash that every lane width of this build and machine ends in, and every number of threads. Errors: two differ.
Result<Hash128> common_hash(const sim::SceneDef& scene, std::uint64_t steps) {
  Result<Hash128> hash = final_hash(scene, steps, sim::LaneWidth::kOne);
  if (!hash) return hash;
  if (Status same = same_in_lanes(scene, steps, *hash); !same) return same.error();
  if (scene.world.method == sim::Method::kThesis) return hash;
  if (Status same = same_in_threads(scene, steps, *hash); !same) return same.error();
  return hash;
}

Status run(std::string_view argument, bool one_lane) {
  const std::size_t colon = argument.rfind(':');
  const std::string path(argument.substr(0, colon));
  std::uint64_t steps = 0;
  const bool has_steps =
      colon != std::string_view::npos &&
      std::from_chars(argument.data() + colon + 1, argument.data() + argument.size(), steps).ec == std::errc();
  if (!has_steps) return bad_input("found \"" + std::string(argument) + "\", wanted SCENE.toml:STEPS");
  std::ifstream file(path, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  if (!file) return bad_input(path + ": cannot be read");
  const Result<sim::SceneDef> scene = scenes::parse_scene(text, path);
  if (!scene) return scene.error();
  const Result<Hash128> hash = one_lane ? final_hash(*scene, steps, sim::LaneWidth::kOne) : common_hash(*scene, steps);
  if (!hash) return hash.error();
  std::printf("%s %llu %s\n", scene->name.c_str(), static_cast<unsigned long long>(steps), to_string(*hash).c_str());
  return {};
}

}  // namespace
}  // namespace tumble

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: determinism [--one-lane] SCENE.toml:STEPS...\n", stderr);
    return 2;
  }
  const bool one_lane = std::string_view(argv[1]) == "--one-lane";  // a build of which lanes may differ
  for (int i = one_lane ? 2 : 1; i < argc; ++i) {
    if (const tumble::Status status = tumble::run(argv[i], one_lane); !status) {
      std::fprintf(stderr, "determinism: %s\n", status.error().message.c_str());
      return status.error().kind == tumble::ErrorKind::kBadInput ? 2 : 4;
    }
  }
  return 0;
}
