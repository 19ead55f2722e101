// The golden cases as scenes: each must read without a complaint and start.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tumble/scenes/scene_file.h"
#include "tumble/sim/step.h"
#include "tumble/sim/world.h"

namespace tumble::scenes {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> case_files() {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(TUMBLE_SOURCE_DIR "/golden/cases")) {
    if (exists(entry.path() / "scene.toml")) files.push_back(entry.path() / "scene.toml");
  }
  return files;
}

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

sim::SceneDef scene_of(const std::string& name, const std::vector<std::string>& overrides = {}) {
  const fs::path path = fs::path(TUMBLE_SOURCE_DIR "/golden/cases") / name / "scene.toml";
  Result<sim::SceneDef> scene = parse_scene(text_of(path), path.string(), overrides);
  EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().message);
  return scene.ok() ? *scene : sim::SceneDef();
}

TEST(Cases, EachReadsAndStarts) {
  ASSERT_GE(case_files().size(), 13U);
  for (const fs::path& path : case_files()) {
    SCOPED_TRACE(path);
    const std::string text = text_of(path);
    const Result<sim::SceneDef> scene = parse_scene(text, path.string());
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    EXPECT_EQ(scene->name, path.parent_path().filename());
    EXPECT_NE(scene->title, scene->name) << "a case has a title";
    EXPECT_NE(text.find("\ncategory = "), std::string::npos) << "a case says its category";
    EXPECT_NE(text.find("\nmethod = "), std::string::npos) << "a case says its method";
    EXPECT_EQ(text.front(), '#') << "a case begins with what to watch for";
    const Result<sim::World> world = sim::create_world(*scene);
    EXPECT_TRUE(world.ok()) << world.error().message;
  }
}

TEST(Cases, HaveTheBodiesOfTheThesis) {
  EXPECT_EQ(scene_of("tilted_grid").boxes.size(), 400U);
  EXPECT_EQ(scene_of("tilted_grid").steps, 1500U);
  EXPECT_EQ(scene_of("brick_wall").boxes.size(), 221U);
  EXPECT_EQ(scene_of("brick_tower").boxes.size(), 221U);
  EXPECT_EQ(scene_of("thin_long").boxes.size(), 60U);
  EXPECT_EQ(scene_of("size_ratio").boxes.size(), 19U);
  EXPECT_EQ(scene_of("pile").boxes.size(), 512U);
}

TEST(Cases, StackedOnesStartFrozenAndOneBodyIsThrown) {
  for (const char* name : {"tower", "pyramid", "brick_wall", "brick_tower", "thin_long", "freeze_and_wake"}) {
    SCOPED_TRACE(name);
    const sim::SceneDef scene = scene_of(name);
    for (const sim::BoxDef& box : scene.boxes) EXPECT_TRUE(box.frozen) << box.id;
    ASSERT_EQ(scene.inputs.size(), 1U);
    EXPECT_NE(std::get_if<sim::Throw>(&scene.inputs[0].command), nullptr);
  }
}

TEST(Cases, SizesSpanFifteenThousandToOne) {
  const sim::SceneDef scene = scene_of("size_ratio");
  EXPECT_NEAR(scene.boxes.back().mass / scene.boxes.front().mass, 15625, 1e-6);
}

TEST(Cases, FrictionScenesDifferInNothingButFriction) {
  const sim::SceneDef with = scene_of("friction_with");
  sim::SceneDef without = scene_of("friction_without", {"material.friction=0.6"});
  without.name = with.name;
  without.title = with.title;
  EXPECT_EQ(with, without);
}

TEST(Cases, GridIsTheSameAtEverySizeThatTestsAskFor) {
  const sim::SceneDef scene = scene_of("tilted_grid", {"grid.rows=6", "grid.cols=6", "world.dt=0.03333333333333333"});
  EXPECT_EQ(scene.boxes.size(), 36U);
  EXPECT_EQ(scene.steps, 150U);
}

}  // namespace
}  // namespace tumble::scenes
