#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tumble/scenes/scene_file.h"

namespace tumble::scenes {
namespace {

using sim::Vec3;

Result<sim::SceneDef> parse_as(const std::string& text, const std::string& file,
                               const std::vector<std::string>& overrides = {}) {
  return parse_scene(text, file, overrides);
}

sim::SceneDef parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  Result<sim::SceneDef> scene = parse_as(text, "some/test.toml", overrides);
  EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().message);
  return scene.ok() ? *scene : sim::SceneDef();
}

TEST(SceneKeys, EveryKeyHasItsDefault) {
  const sim::SceneDef scene = parse("[[box]]\n");
  EXPECT_EQ(scene.name, "test");
  EXPECT_EQ(scene.title, "test");
  EXPECT_EQ(scene.category, "session");
  EXPECT_EQ(scene.world, sim::WorldDef());
  EXPECT_EQ(scene.steps, 300U);
  sim::Camera camera;
  camera.focus = sim::length(camera.target - camera.position);
  EXPECT_EQ(scene.camera, camera);
  EXPECT_EQ(parse("[[box]]\n[camera]\nposition = [3, 0, 6]\ntarget = [0, 0, 2]\n").camera.focus, 5);
  EXPECT_EQ(scene.light, sim::Light());
  ASSERT_EQ(scene.boxes.size(), 1U);
  sim::BoxDef box;
  box.id = 1;
  box.position = {0, 0, 0.5};
  EXPECT_EQ(scene.boxes[0], box);
}

TEST(SceneKeys, TitlesWorldAndViewAreRead) {
  const sim::SceneDef scene = parse(R"(
name = "my-scene_1.0"
title = "Zwei Würfel"
category = "impact"
[world]
method = "layered"
dt = 0.01
steps = 42
substeps = 4
gravity = [0, 1, -2.5]
ground = false
split_collisions = 3
freezing = false
freeze_energy = 0.5
freeze_time = 2
slip_speed = 0.125
air_drag = 0.25
[material]
friction = 0.7
friction_dynamic = 0.6
restitution = 1
texture = "white"
[[box]]
[camera]
position = [1, 2, 3]
target = [4, 5, 6]
fov = 50
focus = 7
blur = 0
[light]
position = [7, 8, 9]
target = [1, 1, 1]
)");
  EXPECT_EQ(scene.name, "my-scene_1.0");
  EXPECT_EQ(scene.title, "Zwei Würfel");
  EXPECT_EQ(scene.category, "impact");
  const sim::Material material = {0.7, 0.6, 1, sim::Texture::kWhite};
  const sim::WorldDef world = {
      sim::Method::kLayered, 0.01, 4, 3, {0, 1, -2.5}, false, false, 0.5, 2, 0.125, 0.25, material};
  EXPECT_EQ(scene.world, world);
  EXPECT_EQ(scene.steps, 42U);
  EXPECT_EQ(scene.camera, (sim::Camera{{1, 2, 3}, {4, 5, 6}, 50, 7, 0}));
  EXPECT_EQ(scene.light, (sim::Light{{7, 8, 9}, {1, 1, 1}}));
}

TEST(SceneKeys, BoxIsRead) {
  const sim::SceneDef scene = parse(R"(
[[box]]
id = 9007199254740991
size = [1, 2, 3]
mass = 4
position = [-1, 0.5, 9]
orientation = [0, 0, 3, 4]
velocity = [1, 2, 3]
spin = [4, 5, 6]
[[box]]
static = true
density = 0.5
size = [2, 2, 2]
)");
  ASSERT_EQ(scene.boxes.size(), 2U);
  const sim::BoxDef& wall = scene.boxes[0];
  EXPECT_EQ(wall.id, 1U);
  EXPECT_TRUE(wall.is_static);
  EXPECT_EQ(wall.mass, 4);
  const sim::BoxDef& box = scene.boxes[1];
  EXPECT_EQ(box.id, sim::kBodyIdMax);
  EXPECT_EQ(box.size, Vec3(1, 2, 3));
  EXPECT_EQ(box.position, Vec3(-1, 0.5, 9));
  EXPECT_EQ(box.orientation, (sim::Quat{0, 0, 0.6, 0.8}));
  EXPECT_EQ(box.velocity, Vec3(1, 2, 3));
  EXPECT_EQ(box.spin, Vec3(4, 5, 6));
}

TEST(SceneKeys, AxisNeedNotHaveLengthOne) {
  const sim::SceneDef scene =
      parse("[[box]]\naxis = [0, 3, 0]\ndegrees = -180\n[[box]]\naxis = [1, 1, 0]\ndegrees = 60\n");
  EXPECT_EQ(scene.boxes[0].orientation, (sim::Quat{0, 0, -1, 0}));
  EXPECT_NEAR(scene.boxes[1].orientation.w, std::sqrt(0.75), 1e-15);
  EXPECT_NEAR(scene.boxes[1].orientation.x, 0.5 * std::sqrt(0.5), 1e-15);
  EXPECT_EQ(scene.boxes[1].orientation.x, scene.boxes[1].orientation.y);
}

TEST(SceneKeys, SecondsAreRoundedToSteps) {
  EXPECT_EQ(parse("[world]\nseconds = 1\ndt = 0.3\n[[box]]\n").steps, 3U);
  EXPECT_EQ(parse("[world]\nseconds = 5\ndt = 0.0033333333333333335\n[[box]]\n").steps, 1500U);
  EXPECT_EQ(parse("[world]\ndt = 0.1\n[[box]]\n").steps, 50U);
}

TEST(SceneKeys, DynamicFrictionFollowsTheStaticOne) {
  const sim::SceneDef scene = parse(R"(
[material]
friction = 0.9
[[box]]
material = { restitution = 0.5 }
[[box]]
material = { friction = 0.3 }
[[box]]
material = { friction_dynamic = 0.1 }
)");
  EXPECT_EQ(scene.world.ground_material.friction_dynamic, 0.9);
  EXPECT_EQ(scene.boxes[0].material, (sim::Material{0.9, 0.9, 0.5, sim::Texture::kCrate}));
  EXPECT_EQ(scene.boxes[1].material, (sim::Material{0.3, 0.3, 0.2, sim::Texture::kCrate}));
  EXPECT_EQ(scene.boxes[2].material, (sim::Material{0.9, 0.1, 0.2, sim::Texture::kCrate}));
}

TEST(SceneKeys, NameComesFromTheFileOrItsFolder) {
  EXPECT_EQ(parse_as("[[box]]", "golden/cases/tower/scene.toml")->name, "tower");
  EXPECT_EQ(parse_as("[[box]]", "scene.toml")->name, "scene");
  EXPECT_EQ(parse_as("[[box]]", "a/two boxes.v2.toml")->name, "two_boxes.v2");
  EXPECT_EQ(parse_as("[[box]]", "")->name, "scene");
  EXPECT_EQ(parse_as("[[box]]", "../.toml")->name, "scene");
}

constexpr const char* kInputs = R"(
[world]
dt = 0.1
seconds = 2
[[box]]
id = 5
[[box]]
[[input]]
step = 20
kind = "remove"
id = 5
[[input]]
time = 0.5
kind = "throw"
id = 70
velocity = [0, 3, 0]
material = { texture = "brick" }
[[input]]
step = 6
kind = "push"
id = 70
impulse = [1, 2, 3]
at = [4, 5, 6]
[[input]]
step = 2
kind = "push"
id = 1
impulse = [1, 0, 0]
[[input]]
step = 7
kind = "wake"
id = 5
[[input]]
step = 8
kind = "set_velocity"
id = 5
velocity = [1, 1, 1]
spin = [2, 2, 2]
[[input]]
step = 9
kind = "set_gravity"
gravity = [0, 0, 0]
[[input]]
step = 10
kind = "set_dt"
dt = 0.05
)";

TEST(SceneInputs, EveryKindIsReadAndOrderedByStep) {
  const sim::SceneDef scene = parse(kInputs);
  ASSERT_EQ(scene.inputs.size(), 8U);
  sim::Throw thrown;
  thrown.box.id = 70;
  thrown.box.position = {0, 0, 0.5};
  thrown.box.velocity = {0, 3, 0};
  thrown.box.material.texture = sim::Texture::kBrick;
  thrown.box.origin = {sim::Origin::Kind::kInput, 1, 0, 0};
  EXPECT_EQ(scene.inputs[0], (sim::TimedCommand{2, sim::Push{1, {1, 0, 0}, true, {0, 0, 0}}}));
  EXPECT_EQ(scene.inputs[1], (sim::TimedCommand{6, thrown})) << "0.5 s are five steps of 0.1 s, and then comes step 6";
  EXPECT_EQ(scene.inputs[2], (sim::TimedCommand{6, sim::Push{70, {1, 2, 3}, false, {4, 5, 6}}}));
  EXPECT_EQ(scene.inputs[3], (sim::TimedCommand{7, sim::Wake{5}}));
  EXPECT_EQ(scene.inputs[4], (sim::TimedCommand{8, sim::SetVelocity{5, {1, 1, 1}, {2, 2, 2}}}));
  EXPECT_EQ(scene.inputs[5], (sim::TimedCommand{9, sim::SetGravity{{0, 0, 0}}}));
  EXPECT_EQ(scene.inputs[6], (sim::TimedCommand{10, sim::SetDt{0.05}}));
  EXPECT_EQ(scene.inputs[7], (sim::TimedCommand{20, sim::Remove{5}}));
}

constexpr const char* kTwoGrids = "[world]\nseconds = 3\n[[grid]]\nrows = 2\ncols = 2\n[[grid]]\nrows = 2\ncols = 2\n";

TEST(SceneOverrides, ReachTheOnlyTheFirstAndTheNthTable) {
  EXPECT_EQ(parse(kTwoGrids).boxes.size(), 8U);
  EXPECT_EQ(parse(kTwoGrids, {"grid.rows=7"}).boxes.size(), 18U);
  EXPECT_EQ(parse(kTwoGrids, {"grid.rows=7"}).boxes[13].origin.table, 0U);
  EXPECT_EQ(parse(kTwoGrids, {"grid.2.rows=7"}).boxes[13].origin.table, 1U);
  EXPECT_EQ(parse(kTwoGrids, {"grid.1.rows=3", "grid.2.rows=4"}).boxes.size(), 14U);
  EXPECT_EQ(parse(kInputs, {"input.6.velocity=[9, 0, 0]"}).inputs[4].command,
            (sim::Command(sim::SetVelocity{5, {9, 0, 0}, {2, 2, 2}})));
}

TEST(SceneOverrides, TakeTomlValuesAndBareWords) {
  const sim::SceneDef scene = parse(kTwoGrids, {"world.method=layered", "world.dt=0.01", "title=two grids",
                                                "name=\"x\"", "world.gravity=[0,0,-1]", "world.ground=false"});
  EXPECT_EQ(scene.world.method, sim::Method::kLayered);
  EXPECT_EQ(scene.world.dt, 0.01);
  EXPECT_EQ(scene.steps, 300U);
  EXPECT_EQ(scene.title, "two grids");
  EXPECT_EQ(scene.name, "x");
  EXPECT_EQ(scene.world.gravity, Vec3(0, 0, -1));
  EXPECT_FALSE(scene.world.ground);
}

TEST(SceneOverrides, MakeTablesThatTheSceneLeavesOut) {
  const sim::SceneDef scene = parse("[[box]]\n[[box]]\n", {"material.friction=0.9", "camera.fov=30",
                                                           "box.2.material.restitution=1", "box.2.static=true"});
  EXPECT_EQ(scene.boxes[0].material.friction, 0.9);
  EXPECT_EQ(scene.camera.fov, 30);
  EXPECT_EQ(scene.boxes[0].material.restitution, 0.2);
  EXPECT_EQ(scene.boxes[1].material.restitution, 1);
  EXPECT_TRUE(scene.boxes[1].is_static);
}

TEST(SceneOverrides, ReplaceTheKeyThatExcludesTheirs) {
  EXPECT_EQ(parse(kTwoGrids, {"world.steps=7"}).steps, 7U);
  EXPECT_EQ(parse(kTwoGrids, {"world.steps=7", "world.steps=8"}).steps, 8U);
  EXPECT_EQ(parse("[[box]]\nmass = 3\n", {"box.density=2"}).boxes[0].mass, 2);
  const std::string turned = "[[box]]\naxis = [1, 0, 0]\ndegrees = 90\n";
  EXPECT_EQ(parse(turned, {"box.orientation=[1, 0, 0, 0]"}).boxes[0].orientation, sim::Quat());
  EXPECT_EQ(parse(kInputs, {"input.1.time=1.5"}).inputs[7].step, 16U);
}

TEST(SceneOverrides, ShorterSessionLeavesLateInputsOut) {
  const sim::SceneDef scene = parse(kInputs, {"world.steps=8"});
  ASSERT_EQ(scene.inputs.size(), 5U);
  EXPECT_EQ(scene.inputs.back().step, 8U);
}

TEST(SceneOverrides, LastOneWins) { EXPECT_EQ(parse(kTwoGrids, {"grid.rows=3", "grid.rows=4"}).boxes.size(), 12U); }

}  // namespace
}  // namespace tumble::scenes
