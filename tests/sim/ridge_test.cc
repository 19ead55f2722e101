// Two boards that lean on each other stand where friction holds their feet, and fall where it does not.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::SceneDef;
using sim::World;

constexpr double kLength = 1, kThickness = 0.1;  // m

// How far the ridge has come down, m. from_vertical: degrees; friction: over the least that holds the feet.
double sunk(double from_vertical, double friction, int substeps, double seconds = 3) {
  const double radians = from_vertical * 3.14159265358979323846 / 180, s = std::sin(radians), c = std::cos(radians);
  SceneDef scene = on_ground();
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = 1.0 / 60;
  scene.world.substeps = static_cast<std::uint32_t>(substeps);
  scene.world.freezing = false;
  sim::Material material;
  material.friction = friction * 0.5 * (s / c) * (1 - kThickness / kLength * (c / s));
  material.friction_dynamic = material.friction;
  material.restitution = 0;
  scene.world.ground_material = material;
  for (const int side : {-1, 1}) {
    sim::BoxDef board = cube(side < 0 ? 1 : 2,
                             {side * (kLength / 2 * s + kThickness / 2 * c), 0, kLength / 2 * c + kThickness / 2 * s});
    board.size = {kThickness, 0.5, kLength};
    board.mass = 1;
    board.orientation = turn({0, -1.0 * side, 0}, c, s);
    board.material = material;
    scene.boxes.push_back(board);
  }
  World world = made(scene);
  const double before = world.bodies().position.z[0];
  for (int k = 0; k < static_cast<int>(60 * seconds); ++k) advance(world);
  return before - world.bodies().position.z[0];
}

TEST(Ridge, BoardsThatLeanOnEachOtherStand) {
  for (const double degrees : {31.0, 45.0, 55.0}) {
    EXPECT_LT(sunk(degrees, 1.3, 4), 0.002) << degrees;
    EXPECT_LT(sunk(degrees, 2, 4), 0.002) << degrees;
    EXPECT_LT(sunk(degrees, 2, 1), 0.01) << degrees;
  }
}

TEST(Ridge, BoardsWhoseFeetSlipFall) {
  for (const double degrees : {31.0, 45.0, 55.0}) EXPECT_GT(sunk(degrees, 0.9, 4, 1.2), 0.2) << degrees;
}

}  // namespace
}  // namespace tumble::test
