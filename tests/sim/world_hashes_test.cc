// World: what its hashes cover, and which states it is not restored from.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "src/math/grid.h"
#include "src/world/manifold_hashes.h"
#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"
#include "tumble/sim/world.h"
#include "tumble/sim/world_state.h"

namespace tumble::test {
namespace {

using sim::PositionGrid;
using sim::SceneDef;
using sim::Vec3;
using sim::VelocityGrid;
using sim::World;
using sim::WorldState;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A body with everything set and something hidden in every column of the state.
WorldState busy_state() {
  SceneDef scene = tower(3);
  freeze_all(scene);
  scene.boxes[2].frozen = false;
  scene.boxes[2].velocity = {1, 2, 3};
  scene.boxes[2].spin = {0.5, 0.25, 0.125};
  scene.boxes[2].size = {1, 0.75, 0.5};
  scene.boxes[2].orientation = {0.9, 0.1, 0.2, 0.3};
  World world = made(scene);
  advance(world);
  EXPECT_GT(world.state().pairs.size(), 0U);
  EXPECT_GT(world.state().contact_objects.size(), 0U);
  return world.state();
}

struct Field {
  const char* name;
  std::function<void(WorldState&)> change;
};

std::vector<Field> visible_fields() {
  return {
      {"id", [](WorldState& s) { ++s.bodies.id[2]; }},
      {"position.x", [](WorldState& s) { s.bodies.position.x[1] += PositionGrid::kStep; }},
      {"position.y", [](WorldState& s) { s.bodies.position.y[2] += PositionGrid::kStep; }},
      {"position.z", [](WorldState& s) { s.bodies.position.z[0] += PositionGrid::kStep; }},
      {"orientation.w",
       [](WorldState& s) { s.bodies.orientation.w[2] = std::nextafter(s.bodies.orientation.w[2], 2); }},
      {"orientation.x", [](WorldState& s) { s.bodies.orientation.x[0] += 1e-300; }},
      {"orientation.y", [](WorldState& s) { s.bodies.orientation.y[1] += 1e-300; }},
      {"orientation.z", [](WorldState& s) { s.bodies.orientation.z[0] += 1e-300; }},
      {"velocity.x", [](WorldState& s) { s.bodies.velocity.x[2] += VelocityGrid::kStep; }},
      {"velocity.y", [](WorldState& s) { s.bodies.velocity.y[2] += VelocityGrid::kStep; }},
      {"velocity.z", [](WorldState& s) { s.bodies.velocity.z[0] += VelocityGrid::kStep; }},
      {"spin.x", [](WorldState& s) { s.bodies.spin.x[2] += VelocityGrid::kStep; }},
      {"spin.y", [](WorldState& s) { s.bodies.spin.y[1] += VelocityGrid::kStep; }},
      {"spin.z", [](WorldState& s) { s.bodies.spin.z[2] += VelocityGrid::kStep; }},
      {"frozen", [](WorldState& s) { s.bodies.frozen[1] ^= 1U; }},
  };
}

void up(double& value) { value = std::nextafter(value, 1e300); }

std::vector<Field> hidden_fields() {
  return {
      {"step", [](WorldState& s) { ++s.step; }},
      {"low_energy_time", [](WorldState& s) { up(s.bodies.low_energy_time[2]); }},
      {"half_extent.x", [](WorldState& s) { up(s.bodies.half_extent.x[1]); }},
      {"half_extent.y", [](WorldState& s) { up(s.bodies.half_extent.y[2]); }},
      {"half_extent.z", [](WorldState& s) { up(s.bodies.half_extent.z[0]); }},
      {"mass", [](WorldState& s) { up(s.bodies.mass[1]); }},
      {"inverse_mass", [](WorldState& s) { up(s.bodies.inverse_mass[0]); }},
      {"inertia.x", [](WorldState& s) { up(s.bodies.inertia.x[2]); }},
      {"inertia.y", [](WorldState& s) { up(s.bodies.inertia.y[0]); }},
      {"inertia.z", [](WorldState& s) { up(s.bodies.inertia.z[1]); }},
      {"inverse_inertia.x", [](WorldState& s) { up(s.bodies.inverse_inertia.x[2]); }},
      {"inverse_inertia.y", [](WorldState& s) { up(s.bodies.inverse_inertia.y[0]); }},
      {"inverse_inertia.z", [](WorldState& s) { up(s.bodies.inverse_inertia.z[1]); }},
      {"friction", [](WorldState& s) { up(s.bodies.friction[1]); }},
      {"friction_dynamic", [](WorldState& s) { up(s.bodies.friction_dynamic[2]); }},
      {"restitution", [](WorldState& s) { up(s.bodies.restitution[0]); }},
      {"is_static", [](WorldState& s) { s.bodies.is_static[0] ^= 1U; }},
      {"pairs.a", [](WorldState& s) { ++s.pairs.a[0]; }},
      {"pairs.b", [](WorldState& s) { ++s.pairs.b[0]; }},
      {"pairs.planes", [](WorldState& s) { s.pairs.planes[0] ^= 4U; }},
      {"one pair less",
       [](WorldState& s) {
         s.pairs.a.pop_back();
         s.pairs.b.pop_back();
         s.pairs.planes.pop_back();
       }},
      {"contact_objects.body", [](WorldState& s) { ++s.contact_objects.body[0]; }},
      {"contact_objects.object", [](WorldState& s) { --s.contact_objects.object[0]; }},
      {"one contact object less",
       [](WorldState& s) {
         s.contact_objects.body.pop_back();
         s.contact_objects.object.pop_back();
       }},
      {"dt", [](WorldState& s) { up(s.def.dt); }},
      {"substeps", [](WorldState& s) { ++s.def.substeps; }},
      {"split_collisions", [](WorldState& s) { ++s.def.split_collisions; }},
      {"gravity.x", [](WorldState& s) { up(s.def.gravity.x()); }},
      {"gravity.y", [](WorldState& s) { up(s.def.gravity.y()); }},
      {"gravity.z", [](WorldState& s) { up(s.def.gravity.z()); }},
      {"ground", [](WorldState& s) { s.def.ground = !s.def.ground; }},
      {"freezing", [](WorldState& s) { s.def.freezing = !s.def.freezing; }},
      {"freeze_energy", [](WorldState& s) { up(s.def.freeze_energy); }},
      {"freeze_time", [](WorldState& s) { up(s.def.freeze_time); }},
      {"slip_speed", [](WorldState& s) { up(s.def.slip_speed); }},
      {"air_drag", [](WorldState& s) { up(s.def.air_drag); }},
      {"ground friction", [](WorldState& s) { up(s.def.ground_material.friction); }},
      {"ground friction_dynamic", [](WorldState& s) { up(s.def.ground_material.friction_dynamic); }},
      {"ground restitution", [](WorldState& s) { up(s.def.ground_material.restitution); }},
      {"method", [](WorldState& s) { s.def.method = sim::Method::kLayered; }},
  };
}

TEST(Hashes, StateHashChangesWithEveryVisibleField) {
  const WorldState state = busy_state();
  EXPECT_EQ(state_hash(state.bodies), state_hash(busy_state().bodies));
  for (const Field& field : visible_fields()) {
    WorldState changed = state;
    field.change(changed);
    EXPECT_NE(state_hash(changed.bodies), state_hash(state.bodies)) << field.name;
    EXPECT_NE(continuation_hash(changed), continuation_hash(state)) << field.name;
  }
}

TEST(Hashes, ContinuationHashChangesWithEveryHiddenFieldAndStateHashDoesNot) {
  const WorldState state = busy_state();
  EXPECT_EQ(continuation_hash(state), continuation_hash(busy_state()));
  for (const Field& field : hidden_fields()) {
    WorldState changed = state;
    field.change(changed);
    ASSERT_NE(changed, state) << field.name << ": nothing was changed";
    EXPECT_NE(continuation_hash(changed), continuation_hash(state)) << field.name;
    EXPECT_EQ(state_hash(changed.bodies), state_hash(state.bodies)) << field.name;
  }
}

// The memory of method layered: a cube that rests on the ground remembers four points.
TEST(Hashes, ContinuationHashChangesWithTheContactMemory) {
  SceneDef scene = tower(1);
  scene.world.method = sim::Method::kLayered;
  World world = made(scene);
  for (int k = 0; k < 5; ++k) advance(world);
  const WorldState state = world.state();
  ASSERT_EQ(state.contact_memory.size(), 1U);
  ASSERT_EQ(state.contact_memory.feature.size(), 4U);
  const std::vector<Field> fields = {
      {"a", [](WorldState& s) { --s.contact_memory.a[0]; }},
      {"b", [](WorldState& s) { ++s.contact_memory.b[0]; }},
      {"count", [](WorldState& s) { ++s.contact_memory.count[0]; }},
      {"feature", [](WorldState& s) { ++s.contact_memory.feature[3]; }},
      {"friction.x", [](WorldState& s) { s.contact_memory.friction.x[0] += 1; }},
      {"friction.y", [](WorldState& s) { s.contact_memory.friction.y[0] += 1; }},
      {"friction.z", [](WorldState& s) { s.contact_memory.friction.z[0] += 1; }},
      {"twist", [](WorldState& s) { s.contact_memory.twist[0] += 1; }},
      {"impulse", [](WorldState& s) { up(s.contact_memory.impulse[2]); }},
  };
  for (const Field& field : fields) {
    WorldState changed = state;
    field.change(changed);
    EXPECT_NE(continuation_hash(changed), continuation_hash(state)) << field.name;
  }
}

// A mirrored world without tilt has gravity (−0, 0, −9.81): the same world.
TEST(Hashes, SignOfZeroGravityDoesNotCount) {
  WorldState state = busy_state(), mirrored = state;
  mirrored.def.gravity.x() = -0.0;
  EXPECT_EQ(continuation_hash(state), continuation_hash(mirrored));
}

TEST(WorldRestore, RefusesInconsistentLists) {
  const std::vector<Field> faults = {
      {"column", [](WorldState& s) { s.bodies.spin.y.pop_back(); }},
      {"hidden column", [](WorldState& s) { s.bodies.low_energy_time.push_back(0); }},
      {"order of ids", [](WorldState& s) { std::swap(s.bodies.id[0], s.bodies.id[1]); }},
      {"id 0", [](WorldState& s) { s.bodies.id[0] = 0; }},
      {"pair out of range", [](WorldState& s) { s.pairs.b.back() = 3; }},
      {"pair of one body", [](WorldState& s) { s.pairs.b[0] = s.pairs.a[0]; }},
      {"pair column", [](WorldState& s) { s.pairs.planes.pop_back(); }},
      {"unknown plane", [](WorldState& s) { s.pairs.planes[0] = 0x8000; }},
      {"contact object out of range", [](WorldState& s) { s.contact_objects.object[0] = 99; }},
      {"body of a contact object", [](WorldState& s) { s.contact_objects.body.back() = 3; }},
      {"contact object column", [](WorldState& s) { s.contact_objects.object.pop_back(); }},
      {"substeps", [](WorldState& s) { s.def.substeps = 0; }},
  };
  EXPECT_TRUE(World::restore(busy_state()).ok());
  for (const Field& fault : faults) {
    WorldState state = busy_state();
    fault.change(state);
    EXPECT_FALSE(World::restore(state).ok()) << fault.name;
  }
}

// A snapshot may come from anywhere: every value that a step reads is looked at before the first step.
TEST(WorldRestore, RefusesValuesThatCannotBe) {
  const std::vector<Field> faults = {
      {"position", [](WorldState& s) { s.bodies.position.y[1] = kNan; }},
      {"velocity", [](WorldState& s) { s.bodies.velocity.x[2] = 9000; }},
      {"spin", [](WorldState& s) { s.bodies.spin.z[2] = kInfinity; }},
      {"orientation", [](WorldState& s) { s.bodies.orientation.x[1] = kNan; }},
      {"length of orientation", [](WorldState& s) { s.bodies.orientation.w[2] *= 1.001; }},
      {"half_extent", [](WorldState& s) { s.bodies.half_extent.z[0] = 0; }},
      {"mass", [](WorldState& s) { s.bodies.mass[0] = -1; }},
      {"inverse_mass", [](WorldState& s) { s.bodies.inverse_mass[0] = kNan; }},
      {"inertia", [](WorldState& s) { s.bodies.inertia.x[0] = kNan; }},
      {"inverse_inertia", [](WorldState& s) { s.bodies.inverse_inertia.y[0] = -1; }},
      {"friction", [](WorldState& s) { s.bodies.friction[0] = kNan; }},
      {"restitution", [](WorldState& s) { s.bodies.restitution[0] = kInfinity; }},
      {"low_energy_time", [](WorldState& s) { s.bodies.low_energy_time[0] = -1; }},
      {"frozen", [](WorldState& s) { s.bodies.frozen[0] = 2; }},
      {"is_static", [](WorldState& s) { s.bodies.is_static[0] = 3; }},
      {"dt", [](WorldState& s) { s.def.dt = kNan; }},
      {"gravity", [](WorldState& s) { s.def.gravity.y() = kInfinity; }},
  };
  for (const Field& fault : faults) {
    WorldState state = busy_state();
    fault.change(state);
    EXPECT_FALSE(World::restore(state).ok()) << fault.name;
  }
}

// Machines of the other byte order go field by field.
TEST(ManifoldHashes, RowsOfManifoldsAreTheirFields) {
  SceneDef scene = tower(3);
  scene.world.method = sim::Method::kLayered;
  World world = made(scene);
  advance(world);
  Hasher rows, fields;
  sim::hash_manifolds(world.scratch(), rows);
  for (const sim::Manifold& m : world.scratch().manifolds) sim::add_fields(m, fields);
  for (const sim::ManifoldPoint& point : world.scratch().manifold_points) sim::add_fields(point, fields);
  EXPECT_EQ(rows.digest(), fields.digest());
}

}  // namespace
}  // namespace tumble::test
