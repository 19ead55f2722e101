#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "src/base/rng.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::scenes {
namespace {

using sim::BoxDef;
using sim::Vec3;
using Kind = sim::Origin::Kind;

sim::SceneDef parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  Result<sim::SceneDef> scene = parse_scene(text, "test.toml", overrides);
  EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().message);
  return scene.ok() ? *scene : sim::SceneDef();
}

void expect_origin(const BoxDef& box, Kind kind, std::uint32_t table, std::uint32_t row, std::uint32_t column) {
  EXPECT_EQ(box.origin, (sim::Origin{kind, table, row, column})) << "body " << box.id;
}

TEST(Grid, StandsAsTheThesisHasIt) {
  const sim::SceneDef scene = parse("[[grid]]\nrows = 3\ncols = 4\n");
  ASSERT_EQ(scene.boxes.size(), 12U);
  const double s = std::sqrt(0.5);
  for (std::uint32_t row = 0; row < 3; ++row) {
    for (std::uint32_t column = 0; column < 4; ++column) {
      const BoxDef& box = scene.boxes[row * 4 + column];
      EXPECT_EQ(box.position, Vec3((column - 1.5) * 1.25, row * 1.25 * s, 0.5 + s + row * 1.25 * s));
      expect_origin(box, Kind::kGrid, 0, row, column);
    }
  }
  // Turned about x by 45 degrees: half of it is 22.5.
  EXPECT_NEAR(scene.boxes[0].orientation.w, std::cos(std::acos(-1.0) / 8), 1e-15);
  EXPECT_NEAR(scene.boxes[0].orientation.x, std::sin(std::acos(-1.0) / 8), 1e-15);
  EXPECT_EQ(scene.boxes[0].orientation.y, 0);
  EXPECT_EQ(scene.boxes[0].orientation.z, 0);
}

TEST(Grid, IsSymmetricToTheBitWhateverThePitch) {
  for (const char* pitch : {"1.25", "1.3", "0.1"}) {
    const sim::SceneDef scene =
        parse("[[grid]]\nrows = 5\ncols = 7\ntilt = 33.3\nsize = [0.1, 0.2, 0.3]\npitch = " + std::string(pitch));
    ASSERT_EQ(scene.boxes.size(), 35U);
    for (std::size_t row = 0; row < 5; ++row) {
      for (std::size_t column = 0; column < 7; ++column) {
        const BoxDef& box = scene.boxes[row * 7 + column];
        const BoxDef& mirrored = scene.boxes[row * 7 + 6 - column];
        EXPECT_EQ(box.position.x(), -mirrored.position.x());
        EXPECT_EQ(box.position.y(), mirrored.position.y());
        EXPECT_EQ(box.position.z(), mirrored.position.z());
        EXPECT_EQ(box.orientation, scene.boxes[0].orientation);
      }
    }
  }
}

TEST(Grid, BaseIsTheHeightOfTheLowestCorner) {
  const sim::SceneDef scene = parse("[[grid]]\nrows = 1\ncols = 1\ntilt = 30\nbase = 2\nsize = [1, 4, 2]\n");
  EXPECT_DOUBLE_EQ(scene.boxes[0].position.z(), 2 + 0.5 * (4 * 0.5 + 2 * std::sqrt(0.75)));
}

TEST(Tower, StandsFaceOnFace) {
  const sim::SceneDef scene = parse("[[tower]]\ncount = 3\nsize = [1, 2, 0.5]\nmass = 4\nposition = [5, 6, 7]\n");
  ASSERT_EQ(scene.boxes.size(), 3U);
  EXPECT_EQ(scene.boxes[0].position, Vec3(5, 6, 7.25));
  EXPECT_EQ(scene.boxes[1].position, Vec3(5, 6, 7.75));
  EXPECT_EQ(scene.boxes[2].position, Vec3(5, 6, 8.25));
  EXPECT_EQ(scene.boxes[2].mass, 4);
  expect_origin(scene.boxes[2], Kind::kTower, 0, 2, 0);
}

TEST(Tower, TapersInEveryEdgeAndByVolumeInMass) {
  const sim::SceneDef scene = parse("[[tower]]\ncount = 3\nsize = [4, 8, 2]\nmass = 64\ntaper = 0.5\n");
  ASSERT_EQ(scene.boxes.size(), 3U);
  EXPECT_EQ(scene.boxes[1].size, Vec3(2, 4, 1));
  EXPECT_EQ(scene.boxes[2].size, Vec3(1, 2, 0.5));
  EXPECT_EQ(scene.boxes[1].mass, 8);
  EXPECT_EQ(scene.boxes[2].mass, 1);
  EXPECT_EQ(scene.boxes[1].position.z(), 2.5);
  EXPECT_EQ(scene.boxes[2].position.z(), 3.25);
}

TEST(Pyramid, EachRowHasOneBoxLess) {
  const sim::SceneDef scene = parse("[[pyramid]]\nbase = 3\nspacing = 1.5\nposition = [10, 1, 0]\n");
  ASSERT_EQ(scene.boxes.size(), 6U);
  const Vec3 wanted[] = {{8.5, 1, 0.5}, {10, 1, 0.5}, {11.5, 1, 0.5}, {9.25, 1, 1.5}, {10.75, 1, 1.5}, {10, 1, 2.5}};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(scene.boxes[i].position, wanted[i]) << i;
  expect_origin(scene.boxes[4], Kind::kPyramid, 0, 1, 1);
}

TEST(Wall, EvenCoursesGoLeftOddOnesRight) {
  const sim::SceneDef scene =
      parse("[[wall]]\ncourses = 2\nbricks = 3\nsize = [2, 1, 1]\nspacing = 2.5\nshift = 0.25\n");
  ASSERT_EQ(scene.boxes.size(), 6U);
  const Vec3 wanted[] = {{-2.75, 0, 0.5}, {-0.25, 0, 0.5}, {2.25, 0, 0.5},
                         {-2.25, 0, 1.5}, {0.25, 0, 1.5},  {2.75, 0, 1.5}};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(scene.boxes[i].position, wanted[i]) << i;
  expect_origin(scene.boxes[5], Kind::kWall, 0, 1, 2);
}

TEST(Pile, FillsALatticeLayerByLayer) {
  const sim::SceneDef scene = parse("[[pile]]\ncount = [2, 3, 2]\npitch = 1.5\nposition = [0, 0, 4]\n");
  ASSERT_EQ(scene.boxes.size(), 12U);
  EXPECT_EQ(scene.boxes[0].position, Vec3(-0.75, -1.5, 4));
  EXPECT_EQ(scene.boxes[1].position, Vec3(0.75, -1.5, 4));
  EXPECT_EQ(scene.boxes[2].position, Vec3(-0.75, 0, 4));
  EXPECT_EQ(scene.boxes[11].position, Vec3(0.75, 1.5, 5.5));
  expect_origin(scene.boxes[11], Kind::kPile, 0, 1, 5);
}

TEST(Jitter, IsTheDocumentedFunctionOfSeedAndNumber) {
  const std::string plain = "[[tower]]\ncount = 50\nposition = [3, 4, 0]\n";
  const sim::SceneDef still = parse(plain);
  const sim::SceneDef moved = parse(plain + "jitter = { position = 0.25, degrees = 8, seed = 7 }\n");
  ASSERT_EQ(moved.boxes.size(), 50U);
  for (std::size_t i = 0; i < 50; ++i) {
    const BoxDef& box = moved.boxes[i];
    EXPECT_EQ(box.position.x(), 3 + 0.25 * random_symmetric(7, i, 0));
    EXPECT_EQ(box.position.y(), 4 + 0.25 * random_symmetric(7, i, 1));
    EXPECT_EQ(box.position.z(), still.boxes[i].position.z());
    const double half_turn = 2 * std::asin(box.orientation.z) * 180 / std::acos(-1.0);
    EXPECT_NEAR(half_turn, 8 * random_symmetric(7, i, 2), 1e-12);
    EXPECT_EQ(box.orientation.x, 0);
    EXPECT_EQ(box.orientation.y, 0);
  }
}

TEST(Jitter, IsTheSameAgainAndAnotherForAnotherSeed) {
  const std::string text = "[[pile]]\njitter = { position = 0.1, degrees = 5, seed = 1 }\n";
  EXPECT_EQ(parse(text), parse(text));
  const sim::SceneDef other = parse(text, {"pile.jitter.seed=2"});
  EXPECT_NE(parse(text).boxes[0].position, other.boxes[0].position);
}

TEST(Jitter, OfOneGeneratorLeavesTheOthersAlone) {
  const std::string tower = "[[tower]]\njitter = { position = 0.1, seed = 3 }\n";
  const sim::SceneDef alone = parse(tower);
  const sim::SceneDef second = parse("[[grid]]\nrows = 2\ncols = 2\n" + tower);
  EXPECT_EQ(alone.boxes[5].position, second.boxes[9].position);
}

TEST(Jitter, TurnsATiltedBoxAboutTheVertical) {
  const sim::SceneDef scene = parse("[[grid]]\nrows = 1\ncols = 9\njitter = { degrees = 90, seed = 5 }\n");
  const sim::SceneDef flat = parse("[[grid]]\nrows = 1\ncols = 9\n");
  for (std::size_t i = 0; i < 9; ++i) {
    // A turn about the vertical keeps every axis's height.
    const sim::Axes turned = sim::axes_of(scene.boxes[i].orientation);
    const sim::Axes straight = sim::axes_of(flat.boxes[i].orientation);
    EXPECT_NEAR(turned[0].z(), straight[0].z(), 1e-15);
    EXPECT_NEAR(turned[1].z(), straight[1].z(), 1e-15);
    EXPECT_NEAR(turned[2].z(), straight[2].z(), 1e-15);
    EXPECT_NE(turned[0].y(), straight[0].y());
  }
}

TEST(Generators, TakeMaterialDensityAndFrozen) {
  const sim::SceneDef scene = parse(
      "[material]\nfriction = 0.3\n[[pyramid]]\nbase = 2\nsize = [2, 1, 1]\ndensity = 500\nfrozen = true\n"
      "material = { restitution = 0.9, texture = \"brick\" }\n");
  for (const BoxDef& box : scene.boxes) {
    EXPECT_EQ(box.mass, 1000);
    EXPECT_TRUE(box.frozen);
    EXPECT_EQ(box.material, (sim::Material{0.3, 0.3, 0.9, sim::Texture::kBrick}));
  }
}

std::vector<sim::BodyId> ids_of(const sim::SceneDef& scene, Kind kind) {
  std::vector<sim::BodyId> ids;
  for (const BoxDef& box : scene.boxes) {
    if (box.origin.kind == kind) ids.push_back(box.id);
  }
  return ids;
}

using Ids = std::vector<sim::BodyId>;

TEST(BodyIds, BoxesComeFirstThenGeneratorsByKind) {
  const sim::SceneDef scene = parse(
      "[[pile]]\ncount = [2, 1, 1]\n[[tower]]\ncount = 2\n[[box]]\n[[grid]]\nrows = 1\ncols = 2\n[[tower]]\ncount = 1\n"
      "[[box]]\n[[input]]\nstep = 3\nkind = \"throw\"\n");
  EXPECT_EQ(ids_of(scene, Kind::kBox), (Ids{1, 2}));
  EXPECT_EQ(ids_of(scene, Kind::kGrid), (Ids{3, 4}));
  EXPECT_EQ(ids_of(scene, Kind::kTower), (Ids{5, 6, 7}));
  EXPECT_EQ(ids_of(scene, Kind::kPile), (Ids{8, 9}));
  EXPECT_EQ(std::get<sim::Throw>(scene.inputs[0].command).box.id, 10U);
  expect_origin(scene.boxes[6], Kind::kTower, 1, 0, 0);
}

TEST(BodyIds, GivenOnesAreLeftOutWhereverTheyStand) {
  const sim::SceneDef scene = parse(
      "[[box]]\n[[box]]\nid = 2\n[[box]]\n[[tower]]\ncount = 4\n[[tower]]\ncount = 2\nfirst_id = 5\n"
      "[[input]]\nstep = 1\nkind = \"throw\"\nid = 4\n");
  EXPECT_EQ(ids_of(scene, Kind::kBox), (Ids{1, 2, 3}));
  EXPECT_EQ(ids_of(scene, Kind::kTower), (Ids{5, 6, 7, 8, 9, 10}));
  EXPECT_EQ(scene.boxes[3].origin.table, 1U) << "5 and 6 belong to the tower with the first_id";
  for (std::size_t i = 1; i < scene.boxes.size(); ++i) EXPECT_LT(scene.boxes[i - 1].id, scene.boxes[i].id);
}

TEST(BodyIds, ReachUpToTheLastOne) {
  const sim::SceneDef scene = parse("[[tower]]\ncount = 2\nfirst_id = 9007199254740990\n");
  EXPECT_EQ(ids_of(scene, Kind::kTower), (Ids{9007199254740990U, 9007199254740991U}));
  EXPECT_EQ(scene.boxes[1].id, sim::kBodyIdMax);
}

}  // namespace
}  // namespace tumble::scenes
