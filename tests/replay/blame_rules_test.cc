// The rules by which blame sees what a phase left out: kept by every step of this build, broken by each mistake.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "replay/blame/phase_rules.h"
#include "replay/blame/steps_again.h"
#include "tests/support/log_memory.h"
#include "tests/support/sim_scenes.h"
#include "tumble/sim/step.h"
#include "tumble/sim/world.h"

namespace tumble::replay {
namespace {

using sim::Method;

/// Three cubes on each other, a bar that leans on them, and a cube thrown at all that.
sim::SceneDef heap(Method method) {
  sim::SceneDef scene = test::on_ground();
  scene.world.method = method;
  scene.steps = 50;
  for (const unsigned id : {1U, 2U, 3U}) scene.boxes.push_back(test::cube(id, {0.1 * id, 0, id - 0.5}));
  sim::BoxDef bar = test::cube(4, {1.5, 0, 0.1});
  bar.size = {3, 0.2, 0.2};
  scene.boxes.push_back(bar);
  sim::BoxDef thrown = test::cube(5, {-5, 0.1, 1.2});
  thrown.velocity = {25, 0, 0};
  scene.inputs = {{20, sim::Throw{thrown}}};
  return scene;
}

TEST(BlameRules, AreKeptByEveryStepOfThisBuild) {
  for (const Method method : kMethods) {
    Result<LogReader> log = open_memory(record_to_memory(heap(method)));
    ASSERT_TRUE(log.ok());
    StepsAgain steps(*log);
    for (std::uint64_t k = 1; k <= log->last_step(); k += 3) {
      for (sim::BodyId id = 1; id <= (k < 20 ? 4U : 5U); ++id) {
        const Result<BodyAccount> account = steps.account(k, id);
        ASSERT_TRUE(account.ok()) << account.error().message;
        for (const BrokenRule& rule : account->broken) {
          ADD_FAILURE() << "step " << k << ", body " << id << ", " << rule.phase << ": " << rule.text;
        }
      }
    }
  }
}

using Tamper = std::function<void(const std::string& phase, sim::World& world)>;

/// Takes steps of a heap with a mistake made after a phase, and gives the rules that the last of them breaks.
class Mistaken : public sim::Observer {
 public:
  Mistaken(sim::World& world, sim::BodyId body, Tamper tamper)
      : world_(world), rules_(world, body), tamper_(std::move(tamper)) {}
  void phase_done(std::uint32_t substep, std::size_t phase, const sim::World& world) override {
    const std::string name = sim::phase_table(world.state().def.method).phases[phase].name;
    tamper_(name, world_);
    rules_.phase_done(substep, name, world, {});
  }
  std::vector<BrokenRule> broken() { return rules_.take(); }

 private:
  sim::World& world_;
  PhaseRules rules_;
  Tamper tamper_;
};

std::vector<std::string> broken_by(Method method, std::uint64_t steps, sim::BodyId body, const Tamper& tamper) {
  Result<sim::World> made = sim::create_world(heap(method));
  EXPECT_TRUE(made.ok());
  sim::World world = *std::move(made);
  for (std::uint64_t k = 1; k < steps; ++k) EXPECT_TRUE(sim::step(world).ok());
  Mistaken mistaken(world, body, tamper);
  EXPECT_TRUE(sim::step(world, &mistaken).ok());
  std::vector<std::string> phases;
  for (const BrokenRule& rule : mistaken.broken()) phases.push_back(rule.phase + ": " + rule.value);
  return phases;
}

bool has(const std::vector<std::string>& all, const std::string& one) {
  return std::ranges::find(all, one) != all.end();
}

// The observer is told of no share of any contact, as of a phase that starts from no impulse.
TEST(BlameRules, AnImpulseMustBeCarriedIntoTheNextSubstep) {
  const auto found = broken_by(Method::kLayered, 10, 2, [](const std::string&, sim::World&) {});
  EXPECT_TRUE(has(found, "apply_forces: carried impulse"));
}

TEST(BlameRules, SeparationsFollowTheMotion) {
  const auto found = broken_by(Method::kLayered, 10, 2, [](const std::string& phase, sim::World& world) {
    if (phase != "integrate_positions") return;
    for (sim::PointBatch& point : world.mutable_scratch().contact_batches.points) {
      for (double& separation : point.separation.of) separation += 1e-6;
    }
  });
  EXPECT_TRUE(has(found, "integrate_positions: separation"));
}

TEST(BlameRules, BoxesThatOverlapAreAPair) {
  for (const Method method : kMethods) {
    const char* const phase_of_pairs = method == Method::kThesis ? "find_pairs" : "find_near_pairs";
    const auto found = broken_by(method, 10, 2, [&](const std::string& phase, sim::World& world) {
      if (phase == phase_of_pairs) world.mutable_state().pairs.clear();
    });
    EXPECT_TRUE(has(found, std::string(phase_of_pairs) + ": pair"));
  }
}

TEST(BlameRules, PlanesAreKeptWhileTheySeparateAndForgottenAfter) {
  const auto forgotten = broken_by(Method::kThesis, 10, 2, [](const std::string& phase, sim::World& world) {
    if (phase == "find_pairs") world.mutable_scratch().old_planes.assign(world.state().pairs.size(), 0x7FFF);
  });
  EXPECT_TRUE(has(forgotten, "find_pairs: planes"));
  const auto kept = broken_by(Method::kThesis, 10, 2, [](const std::string& phase, sim::World& world) {
    if (phase != "recheck_planes") return;
    for (std::uint16_t& planes : world.mutable_state().pairs.planes) planes = 0x7FFF;
  });
  EXPECT_TRUE(has(kept, "recheck_planes: planes"));
}

}  // namespace
}  // namespace tumble::replay
