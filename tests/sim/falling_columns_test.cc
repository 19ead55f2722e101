// Method layered where boxes move by more than their thickness in a step: a body that a third one stops or hits must
// meet what its own path does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::BodyIndex;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

struct Column {
  std::uint32_t count;
  double gap, wide, thick, restitution;  // gap: m, between centres and from the ground to the first
  double dt = 1.0 / 60;
  std::uint32_t substeps = 8;
  double seconds = 5;
};

std::string name(const Column& c) {
  return std::to_string(c.count) + " boxes, " + std::to_string(c.wide) + " m wide, " + std::to_string(c.thick) +
         " m thick, gap " + std::to_string(c.gap) + " m, restitution " + std::to_string(c.restitution) + ", dt " +
         std::to_string(c.dt) + " s, substeps " + std::to_string(c.substeps);
}

SceneDef scene_of(const Column& c) {
  SceneDef scene = on_ground();
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = c.dt;
  scene.world.substeps = c.substeps;
  scene.world.ground_material.restitution = c.restitution;
  for (std::uint32_t k = 0; k < c.count; ++k) {
    sim::BoxDef box = cube(k + 1, {0, 0, c.gap * (k + 1)});
    box.size = {c.wide, c.wide, c.thick};
    box.material.restitution = c.restitution;
    scene.boxes.push_back(box);
  }
  return scene;
}

// The largest overlap of a box with the next, or of the lowest with the ground, as a part of the thickness; 1 or more:
// the boxes have lost their order.
double overlap(const World& world, double thick) {
  const sim::Bodies& bodies = world.bodies();
  double most = (0.5 * thick - bodies.position[0].z()) / thick;
  for (BodyIndex i = 0; i + 1 < bodies.size(); ++i) {
    most = std::max(most, 1 - (bodies.position[i + 1].z() - bodies.position[i].z()) / thick);
  }
  return most;
}

struct Overlaps {
  double most = 0, last = 0;
};
Overlaps overlaps_of(const Column& c) {
  World world = made(scene_of(c));
  Overlaps found;
  for (int k = 0; k < static_cast<int>(c.seconds / c.dt); ++k) {
    advance(world);
    found.last = overlap(world, c.thick);
    found.most = std::max(found.most, found.last);
  }
  return found;
}

void expect_order(const Column& c, double most, double last) {
  const Overlaps found = overlaps_of(c);
  EXPECT_LT(found.most, most) << name(c);
  EXPECT_LT(found.last, last) << name(c);
}

TEST(FallingColumns, KeepTheirOrder) {
  for (const double wide : {1.0, 0.05}) {
    for (const double gap : {0.5, 1.0, 2.0, 3.0}) {
      for (const double restitution : {0.0, 0.2}) {
        for (const std::uint32_t count : {2U, 3U, 6U, 8U}) {
          expect_order({count, gap, wide, 0.05, restitution}, 0.75, 0.1);
        }
      }
    }
  }
}

TEST(FallingColumns, KeepTheirOrderAtAnyStep) {
  for (const double thick : {0.02, 0.05}) {
    for (const double wide : {1.0, thick}) {
      expect_order({4, 0.5, wide, thick, 0, 1.0 / 60, 16}, 0.75, 0.1);
      expect_order({4, 0.5, wide, thick, 0.3, 1.0 / 120, 8}, 0.75, 0.1);
      expect_order({8, 1.0, wide, thick, 0, 1.0 / 240, 2}, 0.75, 0.1);
    }
  }
}

TEST(FallingColumns, ThinPlatesStayOnOneAnother) {
  expect_order({20, 0.05, 1, 0.005, 0.2}, 0.6, 0.1);
  for (const double thick : {0.002, 0.005}) {
    expect_order({20, 0.05, 1, thick, 0}, 0.6, 0.1);
    expect_order({5, 0.5, 1, thick, 0}, 0.6, 0.1);
  }
}

// Gravity adds more than the thickness to a way of a step, so the second box could reach the ground within one.
TEST(ThinStacks, StandStill) {
  for (const double thick : {0.0005, 0.001, 0.002}) {
    for (const double wide : {1.0, thick}) {
      SceneDef scene = scene_of({20, thick, wide, thick, 0});
      for (sim::BoxDef& box : scene.boxes) box.position.z() -= 0.5 * thick;
      scene.world.freezing = false;
      World world = made(scene);
      const double top = world.bodies().position[19].z();
      for (int k = 0; k < 120; ++k) advance(world);
      EXPECT_LT(overlap(world, thick), 1e-6) << thick << " " << wide;
      EXPECT_NEAR(world.bodies().position[19].z(), top, 1e-9) << thick << " " << wide;
    }
  }
}

}  // namespace
}  // namespace tumble::test
