#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "src/thesis/update_freezing.h"
#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"

// Cubes and made-up collisions for the tests of freezing.
namespace tumble::test {

using sim::BodyIndex;
using sim::BoxDef;
using sim::ContactObjects;
using sim::kGround;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

inline constexpr double kDt = 0.125;  // four of them are the freeze_time of ½ s, exactly
inline const Vec3 kUp(0, 0, 1), kDown(0, 0, -1);

struct Touch {
  BodyIndex a, b;
  Vec3 normal;  // from a to b
};
inline const Touch kOnGround = {0, kGround, kDown};

// One update_freezing in which exactly these collisions happen.
inline void update(World& world, const std::vector<Touch>& touches, double dt = kDt) {
  sim::Scratch& scratch = world.mutable_scratch();
  scratch.contacts = {};
  scratch.touched.assign(world.bodies().size(), 0);
  for (const Touch& t : touches) {
    scratch.contacts.a.push_back(t.a);
    scratch.contacts.b.push_back(t.b);
    scratch.contacts.normal.push_back(t.normal);
    scratch.touched[t.a] = 1;
    if (t.b != kGround) scratch.touched[t.b] = 1;
  }
  ASSERT_TRUE(test::run_phase(sim::update_freezing, world, dt).ok());
}

inline SceneDef cubes_at(const std::vector<Vec3>& positions) {
  SceneDef scene = on_ground();
  for (const Vec3& position : positions) scene.boxes.push_back(cube(scene.boxes.size() + 1, position));
  return scene;
}

inline World one_cube(const Vec3& velocity, const Vec3& spin) {
  SceneDef scene = cubes_at({{0, 0, 0.5}});
  scene.boxes[0].velocity = velocity;
  scene.boxes[0].spin = spin;
  return made(scene);
}

inline bool is_frozen_after(World& world, int updates, const std::vector<Touch>& touches) {
  for (int k = 0; k < updates; ++k) update(world, touches);
  return world.bodies().frozen[0] != 0;
}

// The contact objects of a body.
inline std::vector<BodyIndex> objects_of(const World& world, BodyIndex body) {
  std::vector<BodyIndex> objects;
  const ContactObjects& all = world.state().contact_objects;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all.body[k] == body) objects.push_back(all.object[k]);
  }
  return objects;
}

}  // namespace tumble::test
