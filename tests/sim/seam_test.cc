// Method layered: boxes slide over flush seams between tiles as over one floor, and over each other's edges as far as
// they miss one another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::SceneDef;
using sim::Vec3;
using sim::World;

constexpr double kGravity = 9.81;

struct Slide {
  double speed = 5, way = 8;  // m/s, m
  double dt = 1.0 / 60;
  std::uint32_t substeps = 8;
  Vec3 direction = {1, 0, 0};  // along x or y
  Vec3 size = {1, 1, 1};
  double step = 0;  // m that every other tile is higher
  double friction = 0;
  bool free_tiles = false;
  double drop = 0;  // m above the tiles
  int rows = 1;     // of tiles, side by side within 4 m
  double spin = 0;  // rad/s, about z
};

std::ostream& operator<<(std::ostream& out, const Slide& s) {
  return out << s.speed << " m/s towards " << s.direction.transpose() << ", dt 1/" << 1 / s.dt << ", substeps "
             << s.substeps << ", size " << s.size.transpose() << ", step " << s.step << ", friction " << s.friction
             << (s.free_tiles ? ", free tiles" : "") << ", drop " << s.drop << ", rows " << s.rows << ", spin "
             << s.spin;
}

// Tiles of 1 m along the way, whose tops lie at z = 1; the box comes last.
SceneDef scene_of(const Slide& s) {
  SceneDef scene = on_ground();
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = s.dt;
  scene.world.substeps = s.substeps;
  scene.world.freezing = false;
  const int tiles = static_cast<int>(s.way) + 5;
  const Vec3 across = Vec3(1, 1, 0) - s.direction.cwiseAbs();
  sim::BodyId id = 0;
  for (int k = 0; k < tiles; ++k) {
    const double up = k % 2 != 0 ? s.step : 0;
    for (int row = 0; row < s.rows; ++row) {
      const double width = 4.0 / s.rows, aside = (row + 0.5) * width - 2;
      scene.boxes.push_back(box(++id, s.direction.cwiseAbs() + across * width + Vec3(0, 0, 1),
                                s.direction * (k - 1.5) + across * aside + Vec3(0, 0, 0.5 + up)));
      scene.boxes.back().is_static = !s.free_tiles;
    }
  }
  scene.boxes.push_back(box(++id, s.size, s.direction * 0.3 + Vec3(0, 0, 1 + s.drop + 0.5 * s.size.z())));
  scene.boxes.back().spin = {0, 0, s.spin};
  scene.boxes.back().velocity = s.direction * s.speed;
  for (sim::BoxDef& b : scene.boxes) b.material = {s.friction, s.friction, 0};
  return scene;
}

// The box after so many seconds: its way, and its speed.
struct End {
  double way, speed, height;
};
End end_of(const Slide& s, double seconds) {
  World world = made(scene_of(s));
  const auto i = static_cast<sim::BodyIndex>(world.bodies().size() - 1);
  const Vec3 start = world.bodies().position[i];
  for (int k = 0; k < std::lround(seconds / s.dt); ++k) advance(world);
  const Vec3 moved = world.bodies().position[i] - start;
  return {moved.dot(s.direction), world.bodies().velocity[i].dot(s.direction), moved.z() + s.drop};
}

void expect_unstopped(const Slide& s) {
  const End end = end_of(s, s.way / s.speed);
  EXPECT_NEAR(end.speed, s.speed, 0.001 * s.speed) << s;
  EXPECT_LT(std::fabs(end.height), 0.001) << s;
}

TEST(Seam, WithoutFrictionABoxKeepsItsSpeed) {
  for (const double dt : {1.0 / 60, 1.0 / 240}) {
    for (const double speed : {0.5, 5.0, 20.0, 60.0}) expect_unstopped({speed, std::max(3.0, 12 * speed * dt), dt});
  }
  for (const std::uint32_t substeps : {1U, 2U, 4U, 32U}) expect_unstopped({5, 8, 1.0 / 60, substeps});
}

TEST(Seam, OfAnySizeAndInAnyDirection) {
  for (const Vec3& size : {Vec3(0.5, 0.5, 0.5), Vec3(2, 1, 0.3), Vec3(1, 1, 3), Vec3(0.3, 0.3, 0.01)}) {
    for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)})
      expect_unstopped({5, 4, 1.0 / 60, 8, direction, size});
  }
}

// A box on many tiles sinks by the slop, and its front a little deeper: no side of a tile may stop it then.
TEST(Seam, OverTilesInRowsAndColumns) {
  for (const int rows : {2, 4, 8}) {
    for (const Vec3& size : {Vec3(2, 2, 1), Vec3(2, 2, 0.1), Vec3(0.8, 0.8, 0.1)}) {
      for (const double speed : {4.0, 20.0}) {
        Slide s;
        s.rows = rows;
        s.size = size;
        s.speed = speed;
        s.way = 2 * speed;
        expect_unstopped(s);
        s.spin = 3;
        expect_unstopped(s);
      }
    }
  }
}

TEST(Seam, AnySlideOverTilesGoesOn) {
  Random random(7);
  for (int k = 0; k < 150; ++k) {
    Slide s;
    s.rows = 1 + static_cast<int>(random.uniform(0, 8));
    s.size = {random.uniform(0.3, 3), random.uniform(0.3, 3), random.uniform(0.05, 1)};
    s.speed = random.uniform(0.5, 20);
    s.dt = random.uniform(0, 1) < 0.5 ? 1.0 / 60 : 1.0 / 30;
    s.substeps = random.uniform(0, 1) < 0.5 ? 8 : 32;
    s.spin = random.uniform(0, 1) < 0.5 ? 0 : random.uniform(0, 10);
    s.free_tiles = random.uniform(0, 1) < 0.2;
    s.way = 6;
    const End end = end_of(s, s.way / s.speed);
    EXPECT_NEAR(end.speed, s.speed, 0.01 * s.speed) << s;
    EXPECT_LT(std::fabs(end.height), 0.002) << s;
  }
}

// Mirrored slides are mirrored to the bit.
TEST(Seam, MirroredSlidesAreAlike) {
  Slide s;
  const End right = end_of(s, 1);
  for (const Vec3& direction : {Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
    s.direction = direction;
    const End end = end_of(s, 1);
    EXPECT_EQ(end.way, right.way) << s;
    EXPECT_EQ(end.speed, right.speed) << s;
  }
}

TEST(Seam, FreeTilesCarryABoxToo) {
  for (const double speed : {0.5, 3.0, 12.0}) {
    Slide s;
    s.speed = speed;
    s.way = 6;
    s.free_tiles = true;
    expect_unstopped(s);
  }
}

TEST(Seam, ATileUpToTheSlopHigherIsNoObstacle) {
  for (const double step : {1e-6, 1e-5, 1e-4, 3e-4, -1e-6, -1e-4}) {
    Slide s;
    s.step = step;
    expect_unstopped(s);
  }
  Slide high;
  high.step = 0.005;
  EXPECT_LT(end_of(high, 1).speed, 4);
}

// v² / (2 μ g), less half a substep's way.
TEST(Seam, WithFrictionABoxStopsWhereCoulombSays) {
  for (const double friction : {0.1, 0.3, 0.6}) {
    for (const double speed : {3.0, 5.0}) {
      Slide s;
      s.speed = speed;
      s.friction = friction;
      s.size = {1, 1, 0.5};
      s.way = speed * speed / (2 * friction * kGravity);
      const End end = end_of(s, speed / (friction * kGravity) + 0.5);
      EXPECT_NEAR(end.way, s.way, 0.01 * s.way + 0.5 * speed * s.dt / s.substeps) << s;
      EXPECT_LT(std::fabs(end.speed), 1e-3) << s;
    }
  }
}

TEST(Seam, ABoxThatLandsOnTilesSlidesOn) {
  Random random(5);
  for (int k = 0; k < 20; ++k) {
    Slide s;
    s.size = {0.6, 0.6, 0.6};
    s.drop = random.uniform(0, 0.3);
    s.speed = random.uniform(1, 8);
    s.way = s.speed * 1.5;
    expect_unstopped(s);
  }
}

}  // namespace
}  // namespace tumble::test
