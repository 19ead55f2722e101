// What hangs over the edge of a static box: a body stays while its centre of mass lies over the box, and tips over the
// edge where it does not. Both methods.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::Method;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

struct Steps {
  double dt = 1.0 / 60;
  std::uint32_t substeps = 8;
};

SceneDef on_static_cubes(Method method, const Steps& steps, bool freezing, const std::vector<Vec3>& places) {
  SceneDef scene = on_ground();
  scene.world.method = method;
  scene.world.dt = steps.dt;
  scene.world.substeps = steps.substeps;
  scene.world.freezing = freezing;
  for (const Vec3& place : places) {
    scene.boxes.push_back(cube(static_cast<sim::BodyId>(scene.boxes.size()) + 1, place));
    scene.boxes.back().is_static = true;
  }
  return scene;
}

// Where the last box is in the end.
Vec3 place_after(const SceneDef& scene, double seconds) {
  World world = made(scene);
  const int steps = static_cast<int>(std::lround(seconds / scene.world.dt));
  for (int k = 0; k < steps; ++k) advance(world);
  return world.bodies().position[scene.boxes.size() - 1];
}

constexpr Method kMethods[] = {Method::kThesis, Method::kLayered};
constexpr Steps kSteps[] = {{1.0 / 60, 8}, {1.0 / 60, 1}, {1.0 / 240, 8}};

// A unit cube on a unit cube, its centre `overhang` from the middle.
Vec3 cube_after(Method method, const Steps& steps, bool freezing, double overhang) {
  SceneDef scene = on_static_cubes(method, steps, freezing, {{0, 0, 0.5}});
  scene.boxes.push_back(cube(2, {overhang, 0, 1.5}));
  return place_after(scene, 5);
}

TEST(Overhang, ACubeTipsOnceItsCentreIsBeyondTheEdge) {
  for (const Method method : kMethods) {
    for (const Steps& steps : kSteps) {
      for (const bool freezing : {true, false}) {
        for (const double overhang : {0.3, 0.45, 0.49}) {
          const Vec3 end = cube_after(method, steps, freezing, overhang);
          EXPECT_LT((end - Vec3(overhang, 0, 1.5)).norm(), 0.005)
              << static_cast<int>(method) << ", 1/" << 1 / steps.dt << ", " << steps.substeps << ", " << overhang;
        }
        for (const double overhang : {0.51, 0.55, 0.7, 0.9, 0.99}) {
          EXPECT_LT(cube_after(method, steps, freezing, overhang).z(), 1.0)
              << static_cast<int>(method) << ", 1/" << 1 / steps.dt << ", " << steps.substeps << ", " << overhang;
        }
      }
    }
  }
}

// Either end of a plank of 4 m on a cube, then only one.
TEST(Overhang, APlankNeedsBothItsSupports) {
  for (const Method method : kMethods) {
    for (const Steps& steps : kSteps) {
      SceneDef both = on_static_cubes(method, steps, true, {{-1.5, 0, 0.5}, {1.5, 0, 0.5}});
      both.boxes.push_back(box(3, {4, 1, 0.25}, {0, 0, 1.125}));
      EXPECT_LT((place_after(both, 3) - Vec3(0, 0, 1.125)).norm(), 0.005) << static_cast<int>(method);
      SceneDef one = on_static_cubes(method, steps, true, {{-1.5, 0, 0.5}});
      one.boxes.push_back(box(2, {4, 1, 0.25}, {0, 0, 1.125}));
      EXPECT_LT(place_after(one, 3).z(), 0.9) << static_cast<int>(method);
    }
  }
}

}  // namespace
}  // namespace tumble::test
