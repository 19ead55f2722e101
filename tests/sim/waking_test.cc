// Thesis III.D: bodies that start frozen, and what wakes them.
#include <cmath>

#include "tests/sim/freezing_scenes.h"

namespace tumble::test {
namespace {

// A frozen start: each cube of a tower takes the one below; a cube 2 mm clear of another touches nothing.
TEST(FrozenStart, TakesTouchingBodiesAsContactObjects) {
  SceneDef scene = tower(3);
  scene.boxes.push_back(cube(4, {5, 0, 0.502}));
  scene.boxes.push_back(cube(5, {0.7505, 0, 1.5}));  // touches the side of cube 2, at its height
  scene.boxes.back().size = {0.5, 0.5, 0.5};
  freeze_all(scene);
  const World world = made(scene);
  EXPECT_EQ(objects_of(world, 0), (std::vector<BodyIndex>{kGround}));
  EXPECT_EQ(objects_of(world, 1), (std::vector<BodyIndex>{0}));
  EXPECT_EQ(objects_of(world, 2), (std::vector<BodyIndex>{1}));
  EXPECT_EQ(objects_of(world, 3), (std::vector<BodyIndex>{}));
  EXPECT_EQ(objects_of(world, 4), (std::vector<BodyIndex>{}));
}

// Fig. 10's bricks: one resting on two neighbours takes both.
TEST(FrozenStart, BrickOnTwoBricksTakesBoth) {
  SceneDef scene = wall(2, 3);
  freeze_all(scene);
  const World world = made(scene);
  EXPECT_EQ(objects_of(world, 3), (std::vector<BodyIndex>{0, 1}));
  EXPECT_EQ(objects_of(world, 5), (std::vector<BodyIndex>{2}));
}

// Packed without a gap, the middle cube of the upper layer meets the four cubes around it and the four diagonal ones
// only along edges and at corners; what carries it is the one below.
TEST(FrozenStart, MeetingAtAnEdgeOrACornerCarriesNothing) {
  SceneDef scene = on_ground();
  for (const double y : {-1, 0, 1}) {
    for (const double x : {-1, 0, 1}) scene.boxes.push_back(cube(scene.boxes.size() + 1, {x, y, 0.5}));
  }
  scene.boxes.push_back(cube(10, {0, 0, 1.5}));
  freeze_all(scene);
  EXPECT_EQ(objects_of(made(scene), 9), (std::vector<BodyIndex>{4}));
}

// A body thrown in frozen rests on what it is put upon, as if it had always been there, and wakes with it.
TEST(FrozenStart, FrozenThrowRestsOnWhatItTouches) {
  SceneDef scene = tower(2);
  freeze_all(scene);
  World world = made(scene);
  BoxDef top = cube(9, {0, 0, 2.5}), beneath = cube(5, {3, 0, 0.5});
  top.frozen = beneath.frozen = true;
  give(world, sim::Throw{top});
  give(world, sim::Throw{beneath});
  EXPECT_EQ(objects_of(world, 0), (std::vector<BodyIndex>{kGround}));
  EXPECT_EQ(objects_of(world, 1), (std::vector<BodyIndex>{0}));
  EXPECT_EQ(objects_of(world, 2), (std::vector<BodyIndex>{kGround}));
  EXPECT_EQ(objects_of(world, 3), (std::vector<BodyIndex>{1}));
  give(world, sim::Remove{2});
  EXPECT_EQ(world.bodies().frozen, (std::vector<std::uint8_t>{1, 1, 0}));
}

std::vector<std::uint8_t> frozen(const World& world) { return world.bodies().frozen; }
using Flags = std::vector<std::uint8_t>;

// "It is possible to activate a frozen object sitting at the top of another object when the bottom object becomes
// activated": one level each time, whichever way the ids run.
TEST(Waking, ClimbsOneLevelAtATime) {
  for (const bool from_top : {false, true}) {
    SceneDef scene = tower(4);
    freeze_all(scene);
    if (from_top) {
      for (std::size_t k = 0; k < 4; ++k) scene.boxes[k].position.z() = 3.5 - static_cast<double>(k);
    }
    World world = made(scene);
    give(world, sim::Wake{from_top ? 4U : 1U});
    const std::vector<Flags> wanted = from_top
                                          ? std::vector<Flags>{{1, 1, 1, 0}, {1, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, 0}}
                                          : std::vector<Flags>{{0, 1, 1, 1}, {0, 0, 1, 1}, {0, 0, 0, 1}, {0, 0, 0, 0}};
    for (const Flags& flags : wanted) {
      EXPECT_EQ(frozen(world), flags);
      update(world, {}, 1e-3);
    }
    EXPECT_EQ(world.state().contact_objects.size(), 0U);
  }
}

TEST(Waking, BodyWithSeveralContactObjectsWakesWithAnyOfThem) {
  for (const sim::BodyId woken : {1U, 2U}) {
    SceneDef scene = wall(2, 2);
    freeze_all(scene);
    World world = made(scene);
    ASSERT_EQ(objects_of(world, 2), (std::vector<BodyIndex>{0, 1}));
    give(world, sim::Wake{woken});
    update(world, {}, 1e-3);
    EXPECT_EQ(frozen(world)[2], 0);
  }
}

TEST(Waking, FollowsARemovedContactObjectAtOnce) {
  SceneDef scene = tower(4);
  freeze_all(scene);
  World world = made(scene);
  give(world, sim::Remove{2});
  EXPECT_EQ(frozen(world), (Flags{1, 0, 1}));
  EXPECT_EQ(objects_of(world, 0), (std::vector<BodyIndex>{kGround}));
  EXPECT_EQ(objects_of(world, 1), (std::vector<BodyIndex>{}));
  EXPECT_EQ(objects_of(world, 2), (std::vector<BodyIndex>{1})) << "rows behind the removed one move up";
  update(world, {}, 1e-3);
  EXPECT_EQ(frozen(world), (Flags{1, 0, 0}));
}

TEST(Waking, FollowsChangedGravity) {
  SceneDef scene = tower(3);
  freeze_all(scene);
  World world = made(scene);
  give(world, sim::SetGravity{{0, 1, -9}});
  EXPECT_EQ(frozen(world), (Flags{0, 0, 0}));
  EXPECT_EQ(world.state().contact_objects.size(), 0U);
}

// Contact objects keep pointing at the right bodies when a body is thrown in between the ids.
TEST(Waking, ContactObjectsFollowTheRowsOfAThrow) {
  SceneDef scene = tower(2);
  scene.boxes[0].id = 10;
  scene.boxes[1].id = 20;
  freeze_all(scene);
  World world = made(scene);
  give(world, sim::Throw{cube(5, {9, 9, 9})});
  give(world, sim::Throw{cube(15, {-9, 9, 9})});
  EXPECT_EQ(objects_of(world, 1), (std::vector<BodyIndex>{kGround}));
  EXPECT_EQ(objects_of(world, 3), (std::vector<BodyIndex>{1}));
}

}  // namespace
}  // namespace tumble::test
