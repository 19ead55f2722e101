// The whole step and each of its phases, by method and number of bodies: tilted_grid, dt 1/30, 4 substeps,
// from the state a second in, when most rows have landed. A phase's time is from the end of the one before to its own
// end, over all accepted substeps; the first phase of a substep therefore includes steps that were tried and undone.
// box_test/… is the test of all fifteen axes alone, over the pairs of 6400 cubes of the same scene, as they stand and
// turned at random: BoxPair, then each lane width.
// Usage: step_bench [--benchmark_filter=layered/.*/6400] …
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "src/base/rng.h"
#include "src/collide/box_pair.h"
#include "src/kernels/kernels_by_width.h"
#include "src/world/scratch.h"
#include "tumble/scenes/scene_file.h"
#include "tumble/sim/step.h"
#include "tumble/threads/worker_threads.h"

namespace {

using namespace tumble;  // NOLINT(google-build-using-namespace): a program of one file
using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kWarmSteps = 30;
constexpr std::size_t kWholeStep = ~std::size_t{0};

/// Columns of cubes in each of the sizes; rows are as many up to 80, then 20.
constexpr std::pair<int, int> kSizes[] = {{6, 6}, {10, 10}, {20, 20}, {40, 40}, {80, 80}, {20, 1280}, {20, 5120}};

/// Adds up the time of one phase.
class PhaseClock : public sim::Observer {
 public:
  explicit PhaseClock(std::size_t phase) : phase_(phase), before_(Clock::now()) {}
  void phase_done(std::uint32_t /*substep*/, std::size_t phase, const sim::World& /*world*/) override {
    const Clock::time_point now = Clock::now();
    if (phase == phase_) seconds_ += std::chrono::duration<double>(now - before_).count();
    before_ = now;
  }
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  std::size_t phase_;
  Clock::time_point before_;
  double seconds_ = 0;
};

/// The world a second into the scene, made on first use. Ends the program if that fails.
const sim::World& warm_world(sim::Method method, int rows, int columns) {
  static std::map<std::pair<sim::Method, int>, sim::World> worlds;
  const auto key = std::pair(method, rows * columns);
  if (const auto known = worlds.find(key); known != worlds.end()) return known->second;
  std::ifstream file(TUMBLE_SOURCE_DIR "/bench/scenes/tilted_grid.toml", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::string changes[] = {std::string("world.method=") + name_of(method), "world.dt=0.03333333333333333",
                                 "world.substeps=4", "grid.rows=" + std::to_string(rows),
                                 "grid.cols=" + std::to_string(columns)};
  const auto fail = [](const Error& error) {
    std::fprintf(stderr, "step_bench: %s\n", error.message.c_str());
    std::exit(2);
  };
  const Result<sim::SceneDef> scene = scenes::parse_scene(text, "tilted_grid.toml", changes);
  if (!scene.ok()) fail(scene.error());
  Result<sim::World> world = sim::create_world(*scene);
  if (!world.ok()) fail(world.error());
  for (std::uint64_t k = 0; k < kWarmSteps; ++k) {
    if (const Result<sim::StepCounters> done = sim::step(*world); !done.ok()) fail(done.error());
  }
  return worlds.emplace(key, *std::move(world)).first->second;
}

void run(benchmark::State& state, sim::Method method, std::pair<int, int> size, std::size_t phase, unsigned threads) {
  const std::unique_ptr<WorkerThreads> workers = worker_threads(threads);
  const sim::World& warm = warm_world(method, size.first, size.second);
  for (auto _ : state) {
    sim::World world = warm;  // not timed
    world.use(workers.get());
    const Clock::time_point begin = Clock::now();
    PhaseClock clock(phase);
    if (!sim::step(world, phase == kWholeStep ? nullptr : &clock).ok()) state.SkipWithError("the step failed");
    const double whole = std::chrono::duration<double>(Clock::now() - begin).count();
    state.SetIterationTime(phase == kWholeStep ? whole : clock.seconds());
  }
  const double bodies = static_cast<double>(size.first) * size.second;
  state.counters["ns_per_body"] =
      benchmark::Counter(bodies * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// "layered/step/400", "layered/step/400/threads:2".
void add(const std::string& what, sim::Method method, std::pair<int, int> size, std::size_t phase,
         unsigned threads = 1) {
  const std::string word = method == sim::Method::kThesis ? "thesis/" : "layered/";
  std::string name = word + what + '/' + std::to_string(size.first * size.second);
  if (threads > 1) name += "/threads:" + std::to_string(threads);
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { run(state, method, size, phase, threads); })
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond);
}

void count_pairs(benchmark::State& state, std::size_t pairs) {
  state.counters["ns_per_pair"] = benchmark::Counter(
      static_cast<double>(pairs) * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// The boxes of the scene as they stand, or each turned in a way of its own.
std::vector<sim::BoxFrame> box_frames(const sim::World& world, bool turned) {
  std::vector<sim::BoxFrame> frames = world.scratch().frames;
  for (std::size_t i = 0; turned && i < frames.size(); ++i) {
    const auto number = [i](std::uint64_t draw) { return random_symmetric(1, i, draw); };
    frames[i].axes = sim::axes_of(sim::normalised({number(0), number(1), number(2), number(3)}));
  }
  return frames;
}

void run_box_pair(benchmark::State& state, bool turned) {
  const sim::World& world = warm_world(sim::Method::kLayered, 80, 80);
  const sim::PairTable& pairs = world.state().pairs;
  const std::vector<sim::BoxFrame> frames = box_frames(world, turned);
  for (auto _ : state) {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const sim::BoxPair pair(frames[pairs.a[k]], frames[pairs.b[k]]);
      benchmark::DoNotOptimize(pair.best(sim::kFacesOfA));
      benchmark::DoNotOptimize(pair.best(sim::kFacesOfB));
      benchmark::DoNotOptimize(pair.best(sim::kEdges));
    }
  }
  count_pairs(state, pairs.size());
}

/// Includes filling the lanes.
void run_box_tests(benchmark::State& state, bool turned, sim::LaneWidth width) {
  const sim::World& world = warm_world(sim::Method::kLayered, 80, 80);
  const sim::PairTable& pairs = world.state().pairs;
  const std::vector<sim::BoxFrame> frames = box_frames(world, turned);
  const sim::BoxTestKernels& kernels = sim::kernels(width).box_tests;
  sim::BoxTests tests;
  tests.frames = frames.data();
  for (auto _ : state) {
    for (std::size_t first = 0; first < pairs.size(); first += tests.count) {
      tests.count = std::min(sim::BoxTests::kMost, pairs.size() - first);
      for (std::size_t k = 0; k < tests.count; ++k) {
        const sim::BodyIndex a = tests.a[k] = pairs.a[first + k], b = tests.b[k] = pairs.b[first + k];
        const sim::Vec3 offset = frames[b].position - frames[a].position;
        for (int axis = 0; axis < 3; ++axis) tests.offset[axis][k] = offset[axis];
      }
      kernels.find_faces(tests);
      kernels.find_edges(tests);
      benchmark::ClobberMemory();
    }
  }
  count_pairs(state, pairs.size());
}

void add_box_tests(bool turned) {
  const std::string prefix = std::string("box_test/") + (turned ? "turned/" : "grid/");
  benchmark::RegisterBenchmark((prefix + "BoxPair").c_str(), [=](benchmark::State& state) {
    run_box_pair(state, turned);
  })->Unit(benchmark::kMicrosecond);
  for (const sim::LaneWidth width : {sim::LaneWidth::kTwo, sim::LaneWidth::kFour, sim::LaneWidth::kEight}) {
    if (!sim::runs_lanes(width)) continue;
    const std::string name = prefix + sim::name_of(width) + "_lanes";
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
      run_box_tests(state, turned, width);
    })->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  for (const sim::Method method : {sim::Method::kThesis, sim::Method::kLayered}) {
    const auto phases = sim::phase_table(method).phases;
    for (const std::pair<int, int>& size : kSizes) {
      add("step", method, size, kWholeStep);
      if (method == sim::Method::kLayered) add("step", method, size, kWholeStep, 2);
      for (std::size_t k = 0; k < phases.size(); ++k) add(phases[k].name, method, size, k);
    }
  }
  for (const bool turned : {false, true}) add_box_tests(turned);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
