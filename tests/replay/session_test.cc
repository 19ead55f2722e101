// Session: inputs come before their step, in order; a session resumes where it was.
#include "tumble/replay/session.h"

#include <gtest/gtest.h>

#include <span>

#include "replay/measure/measure.h"
#include "replay/session/boxes_at.h"
#include "tests/support/log_memory.h"

namespace tumble::replay {
namespace {

TEST(Session, AppliesTheScenesInputsBeforeTheirStep) {
  Result<Session> session = Session::start(scene_with_inputs());
  ASSERT_TRUE(session.ok());
  for (std::uint64_t k = 1; k <= 5; ++k) {
    const Result<TakenStep> taken = session->step();
    ASSERT_TRUE(taken.ok()) << taken.error().message;
    EXPECT_EQ(session->steps_done(), k);
    EXPECT_EQ(taken->inputs.size(), k == 3 ? 2U : k == 5 ? 1U : 0U) << k;
    EXPECT_EQ(taken->dt, k < 5 ? 1.0 / 60 : 1.0 / 100) << "an input before step 5 sets it";
  }
}

TEST(Session, AppliesLiveInputsAfterThoseOfTheScene) {
  Result<Session> session = Session::start(scene_with_inputs());
  for (int k = 0; k < 4; ++k) ASSERT_TRUE(session->step().ok());
  const sim::Command live = sim::SetDt{1.0 / 40};
  const Result<TakenStep> taken = session->step(std::span(&live, 1));
  ASSERT_TRUE(taken.ok());
  ASSERT_EQ(taken->inputs.size(), 2U);
  EXPECT_EQ(taken->inputs[1], live);
  EXPECT_EQ(taken->dt, 1.0 / 40);
}

TEST(Session, NamesInputAndStepOfARefusal) {
  Result<Session> session = Session::start(small_scene());
  ASSERT_TRUE(session->step().ok());
  const sim::Command live = sim::Remove{999};
  const Result<TakenStep> taken = session->step(std::span(&live, 1));
  ASSERT_FALSE(taken.ok());
  EXPECT_EQ(taken.error().message.find("input \"remove\" before step 2: "), 0U) << taken.error().message;
}

TEST(Session, ResumesAStateToTheBit) {
  for (const sim::Method method : kMethods) {
    sim::SceneDef scene = scene_with_inputs(40, method);
    Result<Session> whole = Session::start(scene);
    for (int k = 0; k < 12; ++k) ASSERT_TRUE(whole->step().ok());
    std::erase_if(scene.inputs, [](const sim::TimedCommand& input) { return input.step <= 12; });
    Result<Session> resumed = Session::resume(whole->world().state(), scene);
    ASSERT_TRUE(resumed.ok());
    for (int k = 12; k < 40; ++k) ASSERT_TRUE(whole->step().ok() && resumed->step().ok());
    EXPECT_EQ(sim::state_hash(resumed->world().bodies()), sim::state_hash(whole->world().bodies()));
  }
}

TEST(MeasurerDeathTest, HasNoRowBeforeTheStart) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const Measurer measurer(header_for(small_scene()));
  EXPECT_EXIT((void)measurer.row(), testing::ExitedWithCode(4), "internal check failed: started");
}

TEST(BoxesAt, AReusedIdHasTheMaterialOfItsLastBody) {
  sim::BoxDef before;
  before.id = 5;
  before.material = {0.25, 0.125, 0.5, sim::Texture::kBrick};
  for (double sim::Material::*part :
       {&sim::Material::friction, &sim::Material::friction_dynamic, &sim::Material::restitution}) {
    sim::SceneDef scene;
    scene.boxes = {before};
    scene.boxes[0].material.*part += 0.25;  // thrown again, with another value
    const Result<sim::World> world = sim::create_world(scene);
    ASSERT_TRUE(world.ok()) << world.error().message;
    EXPECT_EQ(boxes_at(world->bodies(), {before}).at(0).material.*part, before.material.*part + 0.25);
  }
}

}  // namespace
}  // namespace tumble::replay
