// Values with known causes, and what blame says of them.
#include "replay/blame/blame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/replay/blame_story.h"
#include "tests/support/log_memory.h"
#include "tests/support/sample_log.h"
#include "tests/support/sim_scenes.h"
#include "tumble/replay/log_writer.h"
#include "tumble/replay/prelude.h"
#include "tumble/replay/session.h"

namespace tumble::replay {
namespace {

using sim::Method;

sim::SceneDef on_ground(Method method, std::vector<sim::BoxDef> boxes, std::uint64_t steps) {
  sim::SceneDef scene = test::on_ground();
  scene.world.method = method;
  scene.boxes = std::move(boxes);
  scene.steps = steps;
  return scene;
}

sim::BoxDef moving(sim::BoxDef box, const sim::Vec3& velocity) {
  box.velocity = velocity;
  return box;
}

std::vector<std::string> phases_of(const Blame& blame) {
  std::vector<std::string> phases;
  for (const BlameAnswer& answer : blame.answers) phases.push_back(answer.phase);
  return phases;
}

bool names(const Blame& blame, const std::string& phase) { return std::ranges::count(phases_of(blame), phase) > 0; }

/// Before and the shares add up to after, to the bit, where the answer says so.
void expect_exact_sums(const Blame& blame) {
  for (const BlameAnswer& answer : blame.answers) {
    if (!answer.exact) continue;
    double sum = 0;
    for (const BlameShare& share : answer.shares) sum += share.amount;
    EXPECT_EQ(std::get<double>(*answer.before) + sum, std::get<double>(answer.after)) << answer.text;
  }
}

TEST(Blame, ReachesThePushThatMovedABody) {
  for (const Method method : kMethods) {
    const Blame found =
        blame_of(floating(method, {{4, sim::Push{1, {3, 0, 0}, true, {0, 0, 0}}}}, 20), {1, "velocity.x", 15, 5});
    ASSERT_FALSE(found.answers.empty());
    const BlameAnswer& first = found.answers.front();
    EXPECT_EQ(first.phase, "inputs") << story(found);
    EXPECT_EQ(first.step, 4U);
    EXPECT_EQ(first.before, FieldValue(0.0));
    EXPECT_EQ(first.after, FieldValue(3.0));
    EXPECT_TRUE(first.text.starts_with("push of body 1")) << first.text;
    EXPECT_EQ(first.origin, "input 1 of the scene");
    EXPECT_TRUE(found.complete);
  }
}

TEST(Blame, PositionComesFromVelocity) {
  const Blame found = blame_of(floating(Method::kLayered, {{4, sim::SetVelocity{1, {0, 2, 0}, {0, 0, 0}}}}, 20),
                               {1, "position.y", 15, 5});
  ASSERT_EQ(phases_of(found), (std::vector<std::string>{"finish_motion", "inputs", "find_near_pairs"})) << story(found);
  EXPECT_EQ(found.answers[0].value, "position.y");
  EXPECT_EQ(found.answers[1].value, "velocity.y");
}

TEST(Blame, GravityFallsToTheStart) {
  for (const Method method : kMethods) {
    const Blame found = blame_of(on_ground(method, {test::cube(1, {0, 0, 20})}, 20), {1, "velocity.z", 20, 9});
    ASSERT_GE(found.answers.size(), 2U);
    EXPECT_EQ(found.answers[0].phase, method == Method::kLayered ? "finish_motion" : "integrate");
    ASSERT_EQ(found.answers[0].shares.size(), 1U);
    EXPECT_EQ(found.answers[0].shares[0].kind, "gravity");
    EXPECT_TRUE(found.complete) << story(found);
    EXPECT_EQ(found.answers.back().phase, "start") << story(found);
  }
}

// A cube at rest gets its motion from the one that was thrown at it.
TEST(Blame, AHitLeadsToTheBodyThatWasThrown) {
  for (const Method method : kMethods) {
    sim::SceneDef scene = floating(method, {}, 40);
    scene.inputs = {{5, sim::Throw{moving(test::cube(2, {-3, 0.1, 5}), {6, 0, 0})}}};
    const Blame found = blame_of(scene, {1, "velocity.x", 40, 20});
    EXPECT_TRUE(found.complete) << story(found);
    ASSERT_FALSE(found.answers.empty());
    EXPECT_EQ(found.answers.back().phase, "inputs") << story(found);
    EXPECT_EQ(found.answers.back().body, 2U);
    EXPECT_TRUE(found.answers.back().text.starts_with("throw of body 2")) << story(found);
    const auto hit = std::ranges::find_if(found.answers, [](const BlameAnswer& answer) {
      return std::ranges::any_of(answer.shares, [](const BlameShare& share) {
        return share.kind == "contact" && share.other == sim::BodyId{2};
      });
    });
    EXPECT_NE(hit, found.answers.end()) << story(found);
    expect_exact_sums(found);
  }
}

TEST(Blame, FrictionStopsASlide) {
  sim::SceneDef scene = on_ground(Method::kLayered, {moving(test::cube(1, {0, 0, 0.5}), {2, 0, 0})}, 15);
  const Blame found = blame_of(scene, {1, "velocity.x", 15, 8});
  ASSERT_FALSE(found.answers.empty());
  const BlameAnswer& first = found.answers.front();
  EXPECT_TRUE(first.phase == "push_contacts" || first.phase == "relax_contacts" || first.phase == "apply_forces")
      << story(found);
  ASSERT_FALSE(first.shares.empty());
  EXPECT_EQ(first.shares[0].kind, "contact");
  EXPECT_FALSE(first.shares[0].other.has_value());
  EXPECT_LT(first.shares[0].amount, 0);
  EXPECT_TRUE(first.exact);
  EXPECT_TRUE(names(found, "find_manifolds")) << story(found);
  EXPECT_EQ(found.answers.back().phase, "start") << story(found);
  expect_exact_sums(found);
}

TEST(Blame, TellsHowABodyOfMethodThesisMeetsTheGround) {
  sim::SceneDef scene = on_ground(Method::kThesis, {moving(test::cube(1, {0, 0, 0.505}), {0, 0, -3})}, 3);
  scene.world.ground_material = {0.9, 0.9, 0};
  scene.boxes[0].material = {0.4, 0.4, 0.25};
  const Blame found = blame_of(scene, {1, "velocity.z", 1, 6});
  const auto meeting = std::ranges::find(found.answers, "approach", &BlameAnswer::value);
  ASSERT_NE(meeting, found.answers.end()) << story(found);
  EXPECT_NEAR(std::get<double>(meeting->after), -3, 0.2) << story(found);
  EXPECT_NE(story(found).find("friction 0.6, restitution 0.25"), std::string::npos) << story(found);
}

TEST(Blame, OverlapsArePartedByTheirContact) {
  sim::SceneDef scene = floating(Method::kLayered, {}, 3);
  scene.boxes.push_back(test::cube(2, {0.9, 0, 5}));
  const Blame found = blame_of(scene, {1, "position.x", 1, 5});
  ASSERT_FALSE(found.answers.empty());
  EXPECT_EQ(found.answers[0].phase, "part_overlaps") << story(found);
  ASSERT_FALSE(found.answers[0].shares.empty());
  EXPECT_EQ(found.answers[0].shares[0].other, sim::BodyId{2});
  EXPECT_LT(found.answers[0].shares[0].amount, 0);
}

TEST(Blame, SleepStopsABody) {
  sim::SceneDef scene = on_ground(Method::kLayered, {moving(test::cube(1, {0, 0, 0.5}), {0.5, 0, 0})}, 120);
  const Blame found = blame_of(scene, {1, "frozen", 120, 3});
  ASSERT_FALSE(found.answers.empty());
  EXPECT_EQ(found.answers[0].phase, "update_sleeping") << story(found);
  EXPECT_EQ(found.answers[0].before, FieldValue(0.0));
  EXPECT_EQ(found.answers[0].after, FieldValue(1.0));
  EXPECT_LT(found.answers[0].step, 120U);
}

TEST(Blame, FirstStateIsTheScene) {
  const Blame found = blame_of(floating(Method::kLayered, {}, 3), {1, "position.z", 0, 3});
  ASSERT_EQ(phases_of(found), std::vector<std::string>{"start"});
  EXPECT_FALSE(found.answers[0].before.has_value());
  EXPECT_TRUE(found.complete);
}

TEST(Blame, RefusesWhatDoesNotExist) {
  sim::SceneDef scene = floating(Method::kLayered, {}, 8);
  scene.inputs = {{3, sim::Throw{test::cube(2, {3, 0, 5})}}, {6, sim::Remove{1}}};
  Result<LogReader> log = open_memory(record_to_memory(scene));
  ASSERT_TRUE(log.ok());
  const auto message = [&](const BlameQuestion& question) {
    const Result<Blame> found = blame(*log, question);
    EXPECT_FALSE(found.ok());
    return found.ok() ? std::string() : found.error().message;
  };
  EXPECT_NE(message({2, "velocity.x", 1, 1}).find("throws it in before step 3"), std::string::npos);
  EXPECT_NE(message({1, "velocity.x", 8, 1}).find("removed it before step 6"), std::string::npos);
  EXPECT_NE(message({9, "velocity.x", 8, 1}).find("found no body 9"), std::string::npos);
  EXPECT_NE(message({2, "velocity.x", 9, 1}).find("found no step 9, wanted 0 to 8"), std::string::npos);
  EXPECT_NE(message({2, "velocity.xx", 8, 1}).find("did you mean \"velocity.x\""), std::string::npos);
}

// The keyframe behind a gap holds the state that the lost steps led to. So every step that is there can be explained.
TEST(Blame, GoesBackToTheStepsThatARecoveredLogLacks) {
  for (const Method method : kMethods) {
    sim::SceneDef scene = floating(method, {{3, sim::Push{1, {3, 0, 0}, true, {0, 0, 0}}}}, 24);
    scene.world.gravity = {0, 0, -9.81};
    Bytes bytes = record_to_memory(scene, {}, 6);
    const std::vector<ChunkPlace> chunks = open_memory(bytes)->chunks();
    ASSERT_EQ(chunks.size(), 4U);
    bytes[chunks[1].offset + kPreludeBytes + 8] ^= std::byte{1};
    const Result<RecoveredLog> recovered = recover_memory(bytes);
    ASSERT_TRUE(recovered.ok()) << recovered.error().message;
    for (const Bytes& hurt : {recovered->bytes, bytes}) {
      Result<LogReader> log = open_memory(hurt);
      ASSERT_TRUE(log.ok());
      const Result<Blame> found = blame(*log, {1, "velocity.z", 20, 9});
      ASSERT_TRUE(found.ok()) << found.error().message;
      ASSERT_FALSE(found->answers.empty());
      EXPECT_EQ(found->answers[0].step, 20U) << story(*found);
      EXPECT_FALSE(found->complete) << story(*found);
      const Result<Blame> first = blame(*log, {1, "position.z", 13, 1});
      ASSERT_TRUE(first.ok()) << first.error().message;
      EXPECT_EQ(first->answers.at(0).step, 13U) << story(*first);
      // Set before the gap.
      const Result<Blame> lost = blame(*log, {1, "velocity.x", 20, 1});
      ASSERT_TRUE(lost.ok()) << lost.error().message;
      EXPECT_EQ(lost->answers.at(0).phase, "lost") << story(*lost);
      EXPECT_EQ(lost->answers.at(0).step, 12U) << story(*lost);
      EXPECT_EQ(lost->answers.at(0).after, FieldValue(lost->value));
      EXPECT_FALSE(lost->complete);
      EXPECT_TRUE(lost->damaged);
      EXPECT_NE(story(*found).find("falling so in step 13 and since; the log lacks step 12"), std::string::npos)
          << story(*found);
      ASSERT_FALSE(blame(*log, {1, "velocity.z", 9, 1}).ok());
      const Result<Blame> last = blame(*log, {1, "velocity.z", 6, 1});  // before the damage
      ASSERT_TRUE(last.ok()) << last.error().message;
      EXPECT_EQ(last->answers.at(0).step, 6U) << story(*last);
    }
    Result<LogReader> log = open_memory(recovered->bytes);
    const Result<Blame> found = blame(*log, {1, "velocity.z", 20, 9});
    EXPECT_EQ(found->ends, "memory.tumble: found no step 12: steps 7 to 12 were lost before the log was recovered");
    ASSERT_EQ(found->notes.size(), 1U);
    EXPECT_NE(found->notes[0].find("steps 7 to 12 were lost"), std::string::npos) << found->notes[0];
    EXPECT_EQ(blame(*log, {1, "velocity.x", 20, 9})->ends, found->ends);
  }
}

// A log whose step 6 no build takes: a velocity was moved by hand, and the hashes follow.
TEST(Blame, ExplainsNothingThatThisBuildDoesNotRepeat) {
  const sim::SceneDef scene = floating(Method::kLayered, {{4, sim::Push{1, {3, 0, 0}, true, {0, 0, 0}}}}, 10);
  const auto disk = std::make_shared<Disk>();
  Result<Session> session = Session::start(scene);
  ASSERT_TRUE(session.ok());
  sim::World world = session->world();
  auto writer = LogWriter::create(std::make_unique<MemorySink>(disk), header_for(scene), world.state());
  ASSERT_TRUE(writer.ok());
  for (std::uint64_t k = 1; k <= 10; ++k) {
    std::vector<sim::Command> inputs;
    if (k == 4) inputs = {scene.inputs[0].command};
    for (const sim::Command& command : inputs) ASSERT_TRUE(sim::apply(world, command).ok());
    sim::PhaseHashes hashes;
    const Result<sim::StepCounters> counters = sim::step(world, &hashes);
    ASSERT_TRUE(counters.ok());
    if (k == 6) world.mutable_state().bodies.velocity.set(0, {7, 0, 0});
    ASSERT_TRUE((*writer)->append({world.state().def.dt, inputs, hashes.words(), *counters}, world.state()).ok());
  }
  ASSERT_TRUE((*writer)->finish().ok());
  Result<LogReader> log = open_memory(disk->bytes);
  ASSERT_TRUE(log.ok());
  const Result<Blame> after = blame(*log, {1, "velocity.x", 8, 5});
  ASSERT_FALSE(after.ok());
  EXPECT_EQ(after.error().kind, ErrorKind::kCannotFinish);
  EXPECT_NE(after.error().message.find("takes step 6 otherwise"), std::string::npos) << after.error().message;
  EXPECT_NE(after.error().message.find("--step 5 can be asked about"), std::string::npos) << after.error().message;
  const Result<Blame> before = blame(*log, {1, "velocity.x", 5, 5});
  EXPECT_TRUE(before.ok());
}

// A plank at rest on two blocks, of which an input removes one: what the other does to it began with that input.
TEST(Blame, InputThatTakesALoadAwayIsNamed) {
  sim::SceneDef scene = on_ground(Method::kLayered, {}, 31);
  scene.world.freezing = false;
  scene.boxes = {test::cube(1, {-1.5, 0, 0.5}), test::cube(2, {1.5, 0, 0.5}),
                 test::box(3, {4, 1, 0.25}, {0, 0, 1.125})};
  scene.boxes[0].is_static = scene.boxes[1].is_static = true;
  scene.inputs = {{31, sim::Remove{2}}};
  const Blame found = blame_of(scene, {3, "spin.y", 31, 9});
  ASSERT_GE(found.answers.size(), 2U);
  EXPECT_EQ(found.answers.back().phase, "inputs") << story(found);
  EXPECT_EQ(found.answers.back().text, "remove of body 2") << story(found);
  EXPECT_EQ(story(found).find("against gravity"), std::string::npos) << story(found);
}

}  // namespace
}  // namespace tumble::replay
