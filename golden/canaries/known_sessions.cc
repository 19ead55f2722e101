#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "golden/canaries/known_answers.h"
#include "golden/hunt/apart/session_pair.h"
#include "golden/hunt/judge/relation.h"
#include "golden/hunt/scene/grammar.h"
#include "src/kernels/box_frame.h"
#include "src/kernels/kernels_by_width.h"
#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/rotation.h"
#include "tumble/sim/step.h"

namespace tumble::golden {
namespace {

struct Way {
  const char* relation;  // of hunt
  const char* name;
  const char* about;
};
constexpr std::array kWays = {
    Way{"repeat", "a session run again has the same bits", "suite"},
    Way{"lanes", "every width of lanes gives the same bits", "suite"},
    Way{"threads", "threads give the same bits", "suite"},
    Way{"resumed", "a step from a snapshot has the same bits", "format"},
    Way{"replayed", "a session through its log has the same bits", "format"},
};

// The first scenes of a seed, of both methods; none was chosen for what it finds. Then the heap, whose bodies several
// threads share. Symmetries are cases of the suite.
constexpr std::uint64_t kSeed = 21;
constexpr std::uint64_t kScenes = 6;

// A box that falls: its session beside itself is within all usual bounds, and beside one that is moved by a millimetre
// is not.
CanaryResult judge_pair() {
  CanaryResult result = {"", false, "as known", "suite"};
  sim::SceneDef scene;
  scene.steps = 8;
  scene.boxes.resize(1);
  scene.boxes[0].id = 1;
  scene.boxes[0].position = {0, 0, 4};
  const Result<hunt::Trace> trace = hunt::trace(scene);
  if (!trace.ok()) {
    result.message = trace.error().message;
    return result;
  }
  std::vector<replay::StepRecord> records = hunt::records_of(*trace);
  const auto broken = [&] {
    const hunt::SessionPair pair(*trace, records);
    std::string names;
    for (const hunt::ApartBound& bound : hunt::usual_bounds()) {
      if (pair.judge(bound).outcome == hunt::Outcome::kBroken) names += bound.measure + " ";
    }
    return names;
  };
  const std::string of_itself = broken();
  for (replay::StepRecord& record : records) record.states.position.x[0] += 1e-3;
  const std::string of_moved = broken();
  result.caught = of_itself.empty() && of_moved == "place ";
  if (!result.caught) result.message = "of itself: " + of_itself + "; of the one that is moved: " + of_moved;
  return result;
}

// Looks at the layers of each sweep, as `blame` and `diff --zoom` do, and at nothing else. Layers in which nothing is
// due are not told.
class Watcher : public sim::LayerObserver {
 public:
  void layer_solved(const sim::Scratch&, const sim::ContactBatches&, std::size_t) override { ++layers; }
  std::uint64_t layers = 0;
};

// A heap of plates and a big one on it: many contacts, some of them overlaps from the start.
sim::SceneDef heap_of_plates() {
  sim::SceneDef scene;
  scene.world.method = sim::Method::kLayered;
  scene.steps = 40;
  for (std::uint64_t k = 0; k < 60; ++k) {
    sim::BoxDef& box = scene.boxes.emplace_back();
    box.id = k + 1;
    const std::uint64_t row = k / 5 % 4, layer = k / 20;
    box.size = k == 59 ? sim::Vec3(4, 3, 0.2) : sim::Vec3(0.6, 0.5, 0.25 + 0.01 * static_cast<double>(k % 7));
    box.position = {0.55 * static_cast<double>(k % 5) - 1, 0.45 * static_cast<double>(row) - 0.6,
                    0.25 + 0.5 * static_cast<double>(layer)};
    if (k == 59) box.position = {0, 0, 2};
    box.spin = {0, 0, static_cast<double>(k % 3)};
  }
  return scene;
}

// Two towers with gaps, which fall into themselves without a bounce, each in its own time: while some layers and
// contacts are solved, nothing is left to solve in others. How many layers are told is due to push_contacts and
// relax_contacts alone.
sim::SceneDef settling_towers() {
  sim::SceneDef scene;
  scene.world.method = sim::Method::kLayered;
  scene.steps = 20;
  for (std::uint64_t k = 0; k < 12; ++k) {
    sim::BoxDef& box = scene.boxes.emplace_back();
    box.id = k + 1;
    const std::uint64_t tower = k / 6, floor = k % 6;
    const double gap = tower == 0 ? 1e-4 : 2e-4;
    box.position = {3 * static_cast<double>(tower), 0, 0.5 + gap + (1 + gap) * static_cast<double>(floor)};
  }
  return scene;
}

// Takes the scene with and without somebody who looks. differs: a step in which that moves a bit.
std::uint64_t told_layers(const sim::SceneDef& scene, std::string& differs) {
  Result<sim::World> plain = sim::create_world(scene), watched = sim::create_world(scene);
  Watcher watcher;
  for (std::uint64_t k = 0; plain.ok() && watched.ok() && k < scene.steps; ++k) {
    watched->mutable_scratch().layers = &watcher;
    const auto one = sim::step(*plain), other = sim::step(*watched);
    if (one.ok() && other.ok() && *one == *other && plain->state() == watched->state()) continue;
    differs = "step " + std::to_string(k + 1) + " differs;";
    break;
  }
  return watcher.layers;
}

CanaryResult watch_layers() {
  CanaryResult result = {"", false, "as known", "suite"};
  std::string differs;
  const std::uint64_t in_heap = told_layers(heap_of_plates(), differs);
  const std::uint64_t in_towers = told_layers(settling_towers(), differs);
  result.caught = differs.empty() && in_heap > 0 && in_towers == 4789;
  if (!result.caught) {
    result.message = differs + " told of " + std::to_string(in_heap) + " and " + std::to_string(in_towers) + " layers";
  }
  return result;
}

// Cubes that make 407.5 turns in a step, by rounding a hair's breadth more: the half turn that is left has a negative
// cosine then, products of zeros have either sign, and no state may tell.
std::string negative_zeros() {
  std::string found;
  for (const sim::Method method : {sim::Method::kThesis, sim::Method::kLayered}) {
    sim::SceneDef scene;
    scene.world.method = method;
    scene.world.gravity = sim::Vec3::Zero();
    scene.world.dt = 0.6250971710633988;
    for (std::uint64_t k = 0; k < 12; ++k) {
      sim::BoxDef& box = scene.boxes.emplace_back();
      box.id = k + 1;
      box.position = {4 * static_cast<double>(k), 0, 4};
      if (k % 4 < 2) box.orientation = {0, 1, 0, 0};
      box.spin[static_cast<int>(k / 4)] = k % 2 == 0 ? 4096 : -4096;
    }
    Result<sim::World> world = sim::create_world(scene);
    if (!world.ok()) return world.error().message;
    std::ptrdiff_t zeros = 0;
    for (int k = 0; k < 8; ++k) {
      if (const auto ok = sim::step(*world); !ok.ok()) return ok.error().message;
      const sim::QuatColumn& q = world->bodies().orientation;
      for (const auto* column : {&q.w, &q.x, &q.y, &q.z})
        zeros += std::ranges::count_if(*column, [](double part) { return part == 0 && std::signbit(part); });
    }
    found += std::to_string(zeros) + " ";
  }
  return found;
}

// A number in [-1, 1), the next of a sequence.
double next_of(std::uint64_t& state) {
  state = state * 6364136223846793005U + 1442695040888963407U;
  return static_cast<double>(state >> 11U) * 0x1p-52 - 1;
}

// Every kernel of the box test over pairs of boxes at random, some of which touch, against the kernels of one lane. A
// separation that is only looked at where it decides nothing would move no bit of a session.
std::string box_tests_by_width() {
  std::vector<sim::BoxFrame> frames;
  sim::BoxTests tests = {};
  std::uint64_t state = kSeed;
  const auto vector = [&state](double size) {
    const double x = next_of(state), y = next_of(state), z = next_of(state);
    return sim::Vec3(size * x, size * y, size * z);
  };
  for (std::size_t k = 0; k < sim::BoxTests::kMost; ++k) {
    for (std::uint32_t* const row : {&tests.a[k], &tests.b[k]}) {
      *row = static_cast<std::uint32_t>(frames.size());
      const sim::Vec3 turn = vector(1);
      frames.push_back({vector(1), sim::axes_of(sim::normalised({1, turn.x(), turn.y(), turn.z()})),
                        vector(0.5) + sim::Vec3(0.75, 0.75, 0.75)});
    }
    const sim::Vec3 offset = frames[tests.b[k]].position - frames[tests.a[k]].position;
    for (int axis = 0; axis < 3; ++axis) tests.offset[axis][k] = offset[axis];
  }
  tests.frames = frames.data();
  tests.count = sim::BoxTests::kMost;
  std::string known;
  for (const sim::LaneWidth width :
       {sim::LaneWidth::kOne, sim::LaneWidth::kTwo, sim::LaneWidth::kFour, sim::LaneWidth::kEight}) {
    if (!sim::runs_lanes(width)) continue;
    sim::BoxTests found = tests;
    sim::kernels(width).box_tests.find_all(found);
    sim::kernels(width).box_tests.find_best(found);
    Hasher hasher;
    for (const sim::BoxTests::Best* best : {&found.faces_of_a, &found.faces_of_b, &found.edges, &found.all})
      for (const auto* column : {&best->axes, &best->separation}) hasher.add(std::span<const double>(*column));
    for (const auto* column : {&found.second_of_a, &found.second_of_b, &found.apart_along_facelike})
      hasher.add(std::span<const double>(*column));
    const std::string digest = to_string(hasher.digest());
    if (known.empty()) known = digest;
    if (digest != known) return std::string("lanes of width ") + sim::name_of(width) + ": other results";
  }
  return "as known";
}

// Sessions computed in one way and another, each scene once for all ways that are asked here.
void ask_ways(CanaryRoll& roll) {
  std::vector<std::pair<const Way*, CanaryResult>> mine;
  for (const Way& way : kWays) {
    if (roll.falls_here(way.name)) mine.emplace_back(&way, CanaryResult{way.name, true, "as known", way.about});
  }
  for (std::uint64_t number = 0; number <= kScenes && !mine.empty(); ++number) {
    const bool is_heap = number == kScenes;
    const Result<hunt::Trace> trace = hunt::trace(is_heap ? heap_of_plates() : hunt::random_scene(kSeed, number));
    for (auto& [way, result] : mine) {
      if (!result.caught) continue;
      const std::string scene =
          is_heap ? "the heap: " : "scene " + std::to_string(number) + " of seed " + std::to_string(kSeed) + ": ";
      const hunt::Judgement one =
          trace.ok() ? hunt::find_relation(way->relation)->judge(*trace) : hunt::broken(0, 0, trace.error().message);
      if (one.outcome != hunt::Outcome::kBroken) continue;
      result.caught = false;
      result.message = scene + "step " + std::to_string(one.step) + ": " + one.what;
    }
  }
  for (auto& [way, result] : mine) roll.add(std::move(result));
}

}  // namespace

void run_known_sessions(CanaryRoll& roll) {
  ask_ways(roll);
  roll.ask("a session a millimetre off is not within bounds", judge_pair);
  roll.known("the box test gives the same bits in every width of lanes", box_tests_by_width);
  roll.known("no zero of a state is negative", negative_zeros, "0 0 ");
  roll.ask("a session that is watched has the same bits", watch_layers);
}

}  // namespace tumble::golden
