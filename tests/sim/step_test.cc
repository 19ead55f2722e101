// The step: phases, substep recursion (thesis V.A), observers, and the errors that stop it.
#include "tumble/sim/step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::Method;
using sim::Phase;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

// What an observer is told, and where the first body was after each phase.
class Witness : public sim::Observer {
 public:
  void phase_done(std::uint32_t substep, std::size_t phase, const World& world) override {
    calls.push_back({substep, phase});
    if (phase == 0) heights.push_back(world.bodies().position.z[0]);
    contacts.push_back(world.scratch().contacts.size());
  }
  // Each substep tells of every phase, once, in order, and so do the substeps.
  [[nodiscard]] bool in_order(std::uint32_t substeps) const {
    const std::size_t phases = sim::phase_table(Method::kThesis).phases.size();
    if (calls.size() != substeps * phases) return false;
    for (std::size_t k = 0; k < calls.size(); ++k) {
      if (calls[k].substep != k / phases || calls[k].phase != k % phases) return false;
    }
    return true;
  }

  struct Call {
    std::uint32_t substep;
    std::size_t phase;
  };
  std::vector<Call> calls;
  std::vector<double> heights;
  std::vector<std::size_t> contacts;
};

// Cubes resting on the ground: each collides in every substep, for gravity pulls it in again.
SceneDef resting(std::uint32_t count, std::uint32_t substeps, std::uint32_t split) {
  SceneDef scene = on_ground();
  scene.world.substeps = substeps;
  scene.world.split_collisions = split;
  scene.world.freezing = false;
  for (std::uint32_t k = 0; k < count; ++k) scene.boxes.push_back(cube(k + 1, {3.0 * k, 0, 0.5}));
  return scene;
}

std::uint32_t substeps_of(const SceneDef& scene) {
  World world = made(scene);
  Witness witness;
  const sim::StepCounters counters = advance(world, &witness);
  EXPECT_TRUE(witness.in_order(counters.substeps));
  EXPECT_EQ(world.state().step, 1U);
  return counters.substeps;
}

TEST(Step, PhasesAreThoseOfChapterThree) {
  std::string names;
  for (const Phase& phase : sim::phase_table(Method::kThesis).phases) names += std::string(phase.name) + ' ';
  EXPECT_EQ(names,
            "integrate find_pairs find_planes find_contacts compute_impulses compute_separation apply_outcomes "
            "recheck_planes update_freezing ");
}

// Five collisions: a limit of five is kept, of four is not.
TEST(Substeps, OneCollisionMoreThanTheLimitHalvesTheStep) {
  EXPECT_EQ(substeps_of(resting(5, 2, 5)), 1U);
  EXPECT_EQ(substeps_of(resting(5, 2, 4)), 2U);
  EXPECT_EQ(substeps_of(resting(1, 2, 0)), 2U);
}

// floor(log2(substeps)) halvings at most: 2 to that power substeps.
TEST(Substeps, RecursionEndsAtTheDepthOfTheScene) {
  for (const auto& [limit, wanted] : std::vector<std::pair<std::uint32_t, std::uint32_t>>{
           {1, 1}, {2, 2}, {3, 2}, {4, 4}, {7, 4}, {8, 8}, {40, 32}, {200, 128}, {1024, 1024}}) {
    EXPECT_EQ(substeps_of(resting(1, limit, 0)), wanted) << "substeps = " << limit;
  }
}

// A cube falls at 1 m/s without gravity from 0.09 m above the ground, in a step of 0.1 s. The whole step collides and
// is halved; the first half is free; the second collides and is halved; its first half ends at 0.075 s, free, its
// second collides. Accepted: 0.05, 0.025 and 0.025 s, told by the height after each integrate.
TEST(Substeps, OnlyTheHalvesThatCollideAreHalvedAgain) {
  SceneDef scene = resting(1, 4, 0);
  scene.world.gravity = Vec3::Zero();
  scene.world.dt = 0.1;
  scene.boxes[0].position.z() = 0.59;
  scene.boxes[0].velocity.z() = -1;
  World world = made(scene);
  Witness witness;
  const sim::StepCounters counters = advance(world, &witness);
  ASSERT_EQ(counters.substeps, 3U);
  EXPECT_TRUE(witness.in_order(3));
  EXPECT_NEAR(witness.heights[0], 0.59 - 0.05, 1e-10);
  EXPECT_NEAR(witness.heights[1], 0.59 - 0.075, 1e-10);
  EXPECT_NEAR(witness.heights[2], 0.59 - 0.1, 1e-10);
  EXPECT_EQ(witness.contacts.front(), 0U);
  EXPECT_EQ(witness.contacts.back(), 1U);
  EXPECT_EQ(counters.contacts, 1U) << "those of rejected substeps do not count";
}

// A step that is halved leaves exactly what two steps of half the size leave: a rejected trial has no trace. Uneven
// boxes, for a trial changes all there is of them, spin included.
TEST(Substeps, RejectedTrialsLeaveNoTrace) {
  int compared = 0;
  for (SceneDef halved : {pile(3), tumble_of_boxes(3, 6)}) {
    jitter(halved, 0.02, 5);
    halved.world.substeps = 8;
    halved.world.split_collisions = 0;
    World one = made(halved);
    for (int step = 0; step < 120; ++step) {
      sim::WorldState before = one.state();
      before.def.dt /= 8;
      before.def.substeps = 1;
      if (advance(one).substeps != 8) continue;  // not halved all the way
      World eight = *World::restore(before);
      for (int k = 0; k < 8; ++k) advance(eight);
      ASSERT_EQ(one.state().bodies, eight.state().bodies) << "step " << step;
      ASSERT_EQ(one.state().pairs, eight.state().pairs) << "step " << step;
      ASSERT_EQ(one.state().contact_objects, eight.state().contact_objects) << "step " << step;
      ++compared;
    }
  }
  EXPECT_GT(compared, 50);
}

TEST(Step, CountsEnergyPairsAndContacts) {
  SceneDef scene = on_ground();
  scene.world.gravity = {0, 0, -10};
  scene.world.dt = 1.0 / 64;
  scene.boxes = {cube(1, {0, 0, 5}), cube(2, {0, 0.5, 6.25})};
  scene.boxes[1].mass = 3;
  scene.boxes[1].position.z() = 6;  // touching from above: a pair, but no collision
  World world = made(scene);
  const sim::StepCounters counters = advance(world);
  EXPECT_EQ(counters.pairs, 1U);
  EXPECT_EQ(counters.contacts, 0U);
  EXPECT_EQ(counters.substeps, 1U);
  const double v = 10.0 / 64, fallen = 0.5 * 10 / 64 / 64;  // both fall freely
  EXPECT_NEAR(counters.kinetic, 0.5 * 4 * v * v, 1e-9);
  EXPECT_NEAR(counters.potential, 10 * (5 + 3 * 6) - 40 * fallen, 1e-8);
  EXPECT_EQ(counters.inputs, 0);
  EXPECT_EQ(counters.removed, 0);
}

// The world's limits: 8192 m/s, 32768 m. The message names step, phase and body.
TEST(StepErrors, BodyBeyondTheLimitsStopsTheStep) {
  SceneDef scene = empty_space();
  scene.boxes = {cube(4, {0, 0, 0}), cube(77, {5, 0, 0})};
  scene.boxes[1].velocity = {0, 0, 8190};
  scene.world.gravity = {0, 0, 1000};
  World fast = made(scene);
  const auto speed = sim::step(fast);
  ASSERT_FALSE(speed.ok());
  EXPECT_EQ(speed.error().kind, ErrorKind::kCannotFinish);
  for (const char* word : {"step 1", "integrate", "body 77", "velocity"}) {
    EXPECT_NE(speed.error().message.find(word), std::string::npos) << speed.error().message;
  }
  scene.world.gravity = Vec3::Zero();
  scene.boxes[1].velocity = {8000, 0, 0};
  scene.boxes[1].position = {32700, 0, 0};
  World far = made(scene);
  const auto place = sim::step(far);
  ASSERT_FALSE(place.ok());
  for (const char* word : {"integrate", "body 77", "position"}) {
    EXPECT_NE(place.error().message.find(word), std::string::npos) << place.error().message;
  }
}

// A light body between a heavy fast one and its spin: the outcome of one contact is beyond the limits.
TEST(StepErrors, ImpulseBeyondTheLimitsNamesItsPhase) {
  SceneDef scene = empty_space();
  scene.boxes = {cube(1, {0, 0, 0}), cube(2, {0.9, 0.05, 0})};
  scene.boxes[0].mass = 1e12;
  scene.boxes[0].velocity = {8000, 0, 0};
  scene.boxes[1].mass = 1e-9;
  for (sim::BoxDef& b : scene.boxes) b.material.restitution = 1;
  scene.world.dt = 1e-7;
  World world = made(scene);
  const auto result = sim::step(world);
  ASSERT_FALSE(result.ok());
  for (const char* word : {"step 1", "compute_impulses", "body 2"}) {
    EXPECT_NE(result.error().message.find(word), std::string::npos) << result.error().message;
  }
}

// NaN and infinity in any column that a step reads or writes are an error, and never spread in silence.
TEST(StepErrors, ValuesThatAreNotFiniteStopTheStep) {
  using Column = std::vector<double>& (*)(sim::Bodies&);
  const std::vector<std::pair<const char*, Column>> columns = {
      {"position", [](sim::Bodies& b) -> std::vector<double>& { return b.position.y; }},
      {"velocity", [](sim::Bodies& b) -> std::vector<double>& { return b.velocity.x; }},
      {"spin", [](sim::Bodies& b) -> std::vector<double>& { return b.spin.z; }},
      {"orientation", [](sim::Bodies& b) -> std::vector<double>& { return b.orientation.x; }},
  };
  for (const auto& [name, column] : columns) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      SceneDef scene = pile(2);
      World world = made(scene);
      column(world.mutable_state().bodies)[3] = bad;
      const auto result = sim::step(world);
      const std::string message = result.ok() ? "no error" : result.error().message;
      EXPECT_NE(message.find("body 4"), std::string::npos) << name << " of " << bad << ": " << message;
    }
  }
}

// The hashes of a step's phases: one word a phase and substep, the same for the same step, others when one bit moves.
TEST(PhaseHashes, TellPhasesAndBitsApart) {
  const auto words = [](double nudge) {
    SceneDef scene = pile(3);
    jitter(scene, 0.02, 5);
    scene.world.substeps = 4;
    World world = made(scene);
    for (int k = 0; k < 30; ++k) advance(world);
    world.mutable_state().bodies.velocity.x[13] += nudge;
    sim::PhaseHashes hashes;
    const sim::StepCounters counters = advance(world, &hashes);
    EXPECT_EQ(hashes.words().size(), counters.substeps * 9U);
    return hashes.words();
  };
  const auto one = words(0), same = words(0), other = words(0x1p-38);
  EXPECT_EQ(one, same);
  EXPECT_NE(one[0], other[0]) << "integrate moved a bit";
}

// A resting cube keeps the step at 64 substeps; another one lands in the second half of them, hard or softly. The rows
// before are alike, the last one, into which substeps 16 to 64 are folded, still tells.
TEST(PhaseHashes, SubstepsBeyondTheLastRowAreFoldedIntoIt) {
  const auto words = [](double restitution) {
    SceneDef scene = resting(2, 64, 0);
    scene.boxes[1].position.z() = 0.56;
    scene.boxes[1].velocity.z() = -6;  // 0.1 m in a step
    scene.boxes[1].material.restitution = restitution;
    World world = made(scene);
    sim::PhaseHashes hashes;
    EXPECT_EQ(advance(world, &hashes).substeps, 64U);
    return hashes.words();
  };
  const auto soft = words(0.25), hard = words(0.5);
  ASSERT_EQ(soft.size(), sim::PhaseHashes::kRowsMax * 9U);
  ASSERT_EQ(hard.size(), soft.size());
  const auto last_row = static_cast<std::ptrdiff_t>(soft.size() - 9);
  EXPECT_TRUE(std::equal(soft.begin(), soft.begin() + last_row, hard.begin()));
  EXPECT_NE(soft[soft.size() - 9], hard[hard.size() - 9]) << "integrate";
  EXPECT_NE(soft[soft.size() - 5], hard[hard.size() - 5]) << "compute_impulses";
}

}  // namespace
}  // namespace tumble::test
