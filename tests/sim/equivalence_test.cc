// Ways of running that must not matter: again, continued from any step, watched or not, with any mix of steps.
#include <gtest/gtest.h>

#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::SceneDef;
using sim::World;
using sim::WorldState;

// A jittered pile with one of every input: bodies thrown in before and behind the others, pushed, removed, woken, sent
// flying; gravity tilted and set back; dt changed. Some start frozen.
SceneDef session() {
  SceneDef scene = pile(3);
  jitter(scene, 0.02, 3);
  for (sim::BoxDef& b : scene.boxes) b.id += 10;
  SceneDef base = tower(3);
  freeze_all(base);
  for (sim::BoxDef& b : base.boxes) {
    b.id += 500;
    b.position.x() += 3.5;
    scene.boxes.push_back(b);
  }
  scene.steps = 120;
  scene.world.substeps = 4;
  sim::BoxDef first = cube(3, {0, -4, 2});
  first.velocity = {0, 10, 1};
  first.size = {0.5, 1.5, 0.75};
  first.spin = {1, 2, 3};
  sim::BoxDef last = first;
  last.id = 900;
  last.position = {4, 1, 4};
  scene.inputs = {{5, sim::Throw{first}},
                  {20, sim::Push{12, {3, -2, 1}, false, {0.25, 0.5, 1.5}}},
                  {25, sim::SetDt{1.0 / 100}},
                  {30, sim::Wake{502}},
                  {35, sim::Throw{last}},
                  {40, sim::SetVelocity{20, {1, 2, 3}, {-1, 4, 2}}},
                  {50, sim::Remove{15}},
                  {51, sim::Remove{501}},
                  {70, sim::SetGravity{{1.5, -2, -9}}},
                  {90, sim::SetGravity{{0, 0, -9.81}}}};
  return scene;
}

SceneDef wall_hit() {
  SceneDef scene = wall(5, 4);
  freeze_all(scene);
  add_thrown_cube(scene);
  scene.steps = 150;
  scene.world.substeps = 8;
  return scene;
}

SceneDef uneven_tumble() {
  SceneDef scene = tumble_of_boxes(4, 1);
  scene.steps = 60;
  scene.world.substeps = 4;
  return scene;
}

std::vector<SceneDef> scenes() { return {session(), wall_hit(), uneven_tumble()}; }

// One step of the session with its inputs; how long dt is depends on the step when `restless`.
void go_on(World& world, const SceneDef& scene, bool restless = false, sim::Observer* observer = nullptr) {
  const std::uint64_t step = world.state().step + 1;
  if (restless) give(world, sim::SetDt{(1 + static_cast<double>(step * 7 % 13)) / 600});
  for (const sim::TimedCommand& input : scene.inputs) {
    if (input.step == step) give(world, input.command);
  }
  advance(world, observer);
}

std::vector<WorldState> all_states(const SceneDef& scene, bool restless = false) {
  World world = made(scene);
  std::vector<WorldState> states = {world.state()};
  while (world.state().step < scene.steps) {
    go_on(world, scene, restless);
    states.push_back(world.state());
  }
  return states;
}

void expect_same(const std::vector<WorldState>& one, const std::vector<WorldState>& other) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    ASSERT_EQ(one[k], other[k]) << "state " << k;
    ASSERT_EQ(continuation_hash(one[k]), continuation_hash(other[k])) << "state " << k;
  }
}

TEST(Equivalence, RunTwice) {
  for (const SceneDef& scene : scenes()) expect_same(all_states(scene), all_states(scene));
}

// From a copy of the state of every step, the next steps give the same states. Three are enough for all but the last
// copy to overlap; every thirtieth goes on to the end.
TEST(Equivalence, ContinuedFromASnapshotOfEveryStep) {
  for (const SceneDef& scene : scenes()) {
    for (const bool restless : {false, true}) {
      const std::vector<WorldState> states = all_states(scene, restless);
      for (std::size_t from = 0; from < states.size(); ++from) {
        Result<World> world = World::restore(states[from]);
        ASSERT_TRUE(world.ok()) << world.error().message;
        const std::size_t end = from % 30 == 0 ? states.size() : std::min(from + 4, states.size());
        for (std::size_t k = from + 1; k < end; ++k) {
          go_on(*world, scene, restless);
          ASSERT_EQ(world->state(), states[k]) << "from " << from << ", state " << k;
        }
      }
    }
  }
}

// A world restored at each step and used for one step only: nothing may hide in what is not the state.
TEST(Equivalence, RestoredAtEveryStep) {
  for (const SceneDef& scene : scenes()) {
    const std::vector<WorldState> states = all_states(scene);
    World world = made(scene);
    while (world.state().step < scene.steps) {
      go_on(world, scene);
      ASSERT_EQ(world.state(), states[world.state().step]);
      world = *World::restore(world.state());
    }
  }
}

// Looks at everything an observer can see.
class Reader : public sim::Observer {
 public:
  void phase_done(std::uint32_t substep, std::size_t phase, const World& world) override {
    hashes_.phase_done(substep, phase, world);
    seen += world.scratch().contacts.size();
  }
  std::size_t seen = 0;

 private:
  sim::PhaseHashes hashes_;
};

TEST(Equivalence, WatchedOrNot) {
  for (const SceneDef& scene : scenes()) {
    World watched = made(scene), alone = made(scene);
    Reader reader;
    while (alone.state().step < scene.steps) {
      go_on(watched, scene, false, &reader);
      go_on(alone, scene);
      ASSERT_EQ(watched.state(), alone.state());
    }
    EXPECT_GT(reader.seen, 100U);
  }
}

TEST(Equivalence, StepOfAnotherLengthEachTime) {
  for (const SceneDef& scene : scenes()) {
    const std::vector<WorldState> states = all_states(scene, true);
    expect_same(states, all_states(scene, true));
    EXPECT_NE(states.back().bodies, all_states(scene).back().bodies) << "dt did change something";
  }
}

TEST(Equivalence, CountersAreTheSameToo) {
  const SceneDef scene = session();
  World one = made(scene), other = made(scene);
  while (one.state().step < scene.steps) {
    for (const sim::TimedCommand& input : scene.inputs) {
      if (input.step != one.state().step + 1) continue;
      give(one, input.command);
      give(other, input.command);
    }
    EXPECT_EQ(advance(one), advance(other));
  }
}

// The canary: one grid step in one body, and the states of a run are not the same.
TEST(Equivalence, CanaryOfOneGridStepIsSeen) {
  const SceneDef scene = uneven_tumble();
  const std::vector<WorldState> states = all_states(scene);
  WorldState state = states[10];
  state.bodies.velocity.y[5] += 0x1p-38;
  World world = *World::restore(state);
  EXPECT_NE(continuation_hash(state), continuation_hash(states[10]));
  go_on(world, scene);
  EXPECT_NE(world.state(), states[11]);
}

}  // namespace
}  // namespace tumble::test
