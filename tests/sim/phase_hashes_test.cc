// What a phase writes is in its hash: each field is changed, one at a time, and the hash has to notice.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "src/world/scratch.h"
#include "tests/sim/phase_fields.h"
#include "tests/support/sim_scenes.h"
#include "tumble/sim/step.h"

namespace tumble::sim {
namespace {

using test::advance;

double& lane(Lanes& lanes) { return lanes.of[0]; }
ContactBatch& batch(World& world) { return world.mutable_scratch().contact_batches.batches.front(); }
PointBatch& point(World& world) { return world.mutable_scratch().contact_batches.points[batch(world).first]; }
/// A batch whose levers have turned.
ContactBatch& turned_batch(World& world) {
  LargeVector<ContactBatch>& all = world.mutable_scratch().contact_batches.batches;
  const auto found = std::ranges::find(all, true, &ContactBatch::levers_turned);
  return found == all.end() ? all.front() : *found;
}
PointBatch& turned_point(World& world) {
  return world.mutable_scratch().contact_batches.points[turned_batch(world).first];
}
ImpactBatch& impact(World& world) {
  std::vector<ImpactBatch>& all = world.mutable_scratch().contact_batches.impacts;
  return all.empty() ? all.emplace_back() : all.front();
}
Manifold& manifold(World& world) { return world.mutable_scratch().manifolds.front(); }
ManifoldPoint& manifold_point(World& world) { return world.mutable_scratch().manifold_points.front(); }
SolverBody& body(World& world) { return world.mutable_scratch().solver_bodies.front(); }
ContactMemory& memory(World& world) { return world.mutable_state().contact_memory; }
Bodies& bodies(World& world) { return world.mutable_state().bodies; }

std::vector<Field> layered_fields() {
  std::vector<Field> fields = {
      {"find_near_pairs", "b", [](World& w) { ++w.mutable_state().pairs.b[0]; }},
      {"find_near_pairs", "turning", [](World& w) { w.mutable_scratch().turning[0] += 1; }},
      {"find_near_pairs", "ranges", [](World& w) { w.mutable_scratch().ranges[0].opposite_high.y() -= 1; }},
      {"find_near_pairs", "hit_unevenly", [](World& w) { w.mutable_scratch().hit_unevenly[0] ^= 1; }},
      {"find_near_pairs", "axes", [](World& w) { w.mutable_scratch().frames[0].axes.axis[2].y() += 1; }},
      {"find_near_pairs", "frame", [](World& w) { w.mutable_scratch().frames[0].position.y() += 1; }},
      {"find_manifolds", "restitution", [](World& w) { manifold(w).restitution += 1; }},
      {"find_manifolds", "friction", [](World& w) { manifold(w).friction += 1; }},
      {"find_manifolds", "friction_dynamic", [](World& w) { manifold(w).friction_dynamic += 1; }},
      {"find_manifolds", "t2", [](World& w) { manifold(w).t2.z() += 1; }},
      {"find_manifolds", "d", [](World& w) { manifold(w).d.x() += 1; }},
      {"find_manifolds", "asleep", [](World& w) { manifold(w).asleep = !manifold(w).asleep; }},
      {"find_manifolds", "separation", [](World& w) { manifold_point(w).separation += 1; }},
      {"wake_islands", "frozen", [](World& w) { bodies(w).frozen[0] ^= 1; }},
      {"wake_islands", "low_energy_time", [](World& w) { bodies(w).low_energy_time[0] += 1; }},
      {"assign_levels", "layered", [](World& w) { ++w.mutable_scratch().layered[0]; }},
      {"carry_weights", "load", [](World& w) { manifold_point(w).load += 1; }},
      {"carry_weights", "impulse", [](World& w) { manifold_point(w).impulse += 1; }},
      {"carry_weights", "solver_mass", [](World& w) { w.mutable_scratch().solver_mass[0] += 1; }},
      {"carry_weights", "lent_along", [](World& w) { w.mutable_scratch().lent_along[0].z() += 1; }},
      {"carry_weights", "held", [](World& w) { w.mutable_scratch().weights.held[0] ^= 1; }},
      {"prepare_manifolds", "in_contact", [](World& w) { w.mutable_scratch().in_contact[0] ^= 1; }},
      {"prepare_manifolds", "inverse_mass", [](World& w) { body(w).inverse_mass += 1; }},
      {"prepare_manifolds", "lent", [](World& w) { body(w).lent.x() += 1; }},
      {"prepare_manifolds", "restitution", [](World& w) { lane(batch(w).restitution) += 1; }},
      {"prepare_manifolds", "force1", [](World& w) { lane(batch(w).force1) += 1; }},
      {"prepare_manifolds", "split_a", [](World& w) { lane(batch(w).split_a) += 1; }},
      {"prepare_manifolds", "response", [](World& w) { lane(batch(w).response[5]) += 1; }},
      {"prepare_manifolds", "impulse", [](World& w) { lane(point(w).impulse) += 1; }},
      {"prepare_manifolds", "load", [](World& w) { lane(point(w).load) += 1; }},
      {"prepare_manifolds", "slop", [](World& w) { lane(batch(w).slop) += 1; }},
      {"prepare_manifolds", "d", [](World& w) { lane(turned_batch(w).d[1]) += 1; }},
      {"prepare_manifolds", "offset", [](World& w) { lane(turned_batch(w).offset) += 1; }},
      {"integrate_positions", "d", [](World& w) { lane(turned_batch(w).d[1]) += 1; }},
      {"integrate_positions", "offset", [](World& w) { lane(turned_batch(w).offset) += 1; }},
      {"integrate_positions", "centre_q", [](World& w) { lane(turned_batch(w).centre_q) += 1; }},
      {"integrate_positions", "p", [](World& w) { lane(turned_point(w).p) += 1; }},
      {"integrate_positions", "q", [](World& w) { lane(turned_point(w).q) += 1; }},
      {"integrate_positions", "separation", [](World& w) { lane(point(w).separation) += 1; }},
      {"integrate_positions", "inverse_inertia", [](World& w) { body(w).inverse_inertia[5] += 1; }},
      {"integrate_positions", "orientation", [](World& w) { bodies(w).orientation.z[0] += 1; }},
      {"integrate_positions", "position", [](World& w) { bodies(w).position.x[0] += 1; }},
      {"bounce_contacts", "stored impulse", [](World& w) { manifold_point(w).impulse += 1; }},
      {"bounce_contacts", "stored separation", [](World& w) { manifold_point(w).separation += 1; }},
      {"bounce_contacts", "stored twist", [](World& w) { manifold(w).twist += 1; }},
      {"finish_motion", "friction", [](World& w) { memory(w).friction.z[0] += 1; }},
      {"finish_motion", "twist", [](World& w) { memory(w).twist[0] += 1; }},
      {"finish_motion", "count", [](World& w) { ++memory(w).count[0]; }},
      {"finish_motion", "a", [](World& w) { ++memory(w).a[0]; }},
      {"finish_motion", "b", [](World& w) { ++memory(w).b[0]; }},
      {"finish_motion", "impulse", [](World& w) { memory(w).impulse[0] += 1; }},
      {"finish_motion", "position", [](World& w) { bodies(w).position.z[0] += 1; }},
      {"finish_motion", "spin", [](World& w) { bodies(w).spin.x[0] += 1; }},
      {"update_sleeping", "low_energy_time", [](World& w) { bodies(w).low_energy_time[0] += 1; }},
  };
  for (const char* phase : {"push_contacts", "relax_contacts"}) {
    fields.push_back({phase, "impulse", [](World& w) { lane(point(w).impulse) += 1; }});
    fields.push_back({phase, "peak", [](World& w) { lane(point(w).peak) += 1; }});
    fields.push_back({phase, "twist", [](World& w) { lane(batch(w).twist) += 1; }});
    fields.push_back({phase, "sliding", [](World& w) { lane(batch(w).sliding) += 1; }});
    fields.push_back({phase, "absorbed", [](World& w) { lane(impact(w).absorbed) += 1; }});
  }
  for (const char* phase :
       {"apply_forces", "push_contacts", "integrate_positions", "relax_contacts", "bounce_contacts"}) {
    fields.push_back({phase, "spin", [](World& w) { body(w).spin.y() += 1; }});
    fields.push_back({phase, "velocity", [](World& w) { body(w).velocity.z() += 1; }});
  }
  return fields;
}

TEST(PhaseHashes, CoverWhatThePhasesOfMethodLayeredWrite) { try_all(Method::kLayered, layered_fields()); }

// A cube that spins into the ground makes a fast pair with it.
std::vector<Field> fast_fields() {
  const auto fast = [](World& world) -> FastContacts& { return world.mutable_scratch().fast; };
  std::vector<Field> fields = {
      {"find_manifolds", "fast pairs", [=](World& w) { ++fast(w).pairs[0].first; }},
      {"find_fast_contacts", "position", [](World& w) { bodies(w).position.z[0] += 1; }},
      {"find_fast_contacts", "orientation", [](World& w) { bodies(w).orientation.z[0] += 1; }},
      {"find_fast_contacts", "velocity", [](World& w) { bodies(w).velocity.z[0] += 1; }},
      {"find_fast_contacts", "spin", [](World& w) { bodies(w).spin.x[0] += 1; }},
      {"find_fast_contacts", "inverse_inertia", [](World& w) { body(w).inverse_inertia[5] += 1; }},
      {"find_fast_contacts", "approach", [=](World& w) { lane(fast(w).batches.points[0].approach) += 1; }},
      {"find_fast_contacts", "mass of a point", [=](World& w) { lane(fast(w).batches.points[0].mass) += 1; }},
      {"find_fast_contacts", "restitution", [=](World& w) { lane(fast(w).batches.batches[0].restitution) += 1; }},
      {"find_fast_contacts", "separation", [=](World& w) { lane(fast(w).batches.points[0].separation) += 1; }},
      {"bounce_fast_contacts", "velocity", [](World& w) { body(w).velocity.z() += 1; }},
      {"bounce_fast_contacts", "spin", [](World& w) { body(w).spin.y() += 1; }},
      {"bounce_fast_contacts", "separation", [=](World& w) { lane(fast(w).batches.points[0].separation) += 1; }},
      {"bounce_fast_contacts", "impulse", [=](World& w) { lane(fast(w).batches.points[0].impulse) += 1; }},
      {"bounce_contacts", "impulse kept", [=](World& w) { fast(w).found.points[0].impulse += 1; }},
      {"bounce_contacts", "friction kept", [=](World& w) { fast(w).found.manifolds[0].force1 += 1; }},
  };
  for (const char* phase : {"push_contacts", "integrate_positions", "relax_contacts"}) {
    fields.push_back({phase, "impulse", [=](World& w) { lane(fast(w).batches.points[0].impulse) += 1; }});
    fields.push_back({phase, "absorbed", [=](World& w) { lane(fast(w).batches.impacts[0].absorbed) += 1; }});
  }
  return fields;
}

TEST(PhaseHashes, CoverWhatIsWrittenOfFastPairs) {
  SceneDef scene = test::on_ground();
  scene.world.method = Method::kLayered;
  scene.boxes = {test::cube(1, {0, 0, 0.6})};
  scene.boxes[0].spin = {20, 3, 1};
  World world = test::made(scene);
  Changer changer(fast_fields());
  advance(world, &changer);
  changer.expect_all_tried();
}

// A cube that bounces in a fast pair takes along the one that lies on it.
TEST(PhaseHashes, CoverWhatABounceTakesAlong) {
  SceneDef scene = test::on_ground();
  scene.world.method = Method::kLayered;
  scene.boxes = {test::cube(1, {0, 0, 0.53}), test::cube(2, {0, 0, 1.53})};
  for (BoxDef& box : scene.boxes) box.velocity = Vec3(0, 0, -5);
  World world = test::made(scene);
  const auto above = [](World& w) -> SolverBody& { return w.mutable_scratch().solver_bodies[1]; };
  Changer changer({
      {"bounce_fast_contacts", "velocity above", [=](World& w) { above(w).velocity.z() += 1; }},
      {"bounce_fast_contacts", "spin above", [=](World& w) { above(w).spin.x() += 1; }},
      {"bounce_fast_contacts", "impulse between", [](World& w) { lane(point(w).impulse) += 1; }},
      {"bounce_fast_contacts", "friction between", [](World& w) { lane(batch(w).twist) += 1; }},
  });
  advance(world, &changer);
  changer.expect_all_tried();
}

// Boxes that overlap at the start are parted; one turns on the way, since the other lies off its middle.
TEST(PhaseHashes, CoverWhatPartingOverlapsWrites) {
  SceneDef scene = test::on_ground();
  scene.world.method = Method::kLayered;
  scene.boxes = {test::cube(1, {0, 0, 0.5}), test::cube(2, {0.75, 0.25, 1.375})};
  World world = test::made(scene);
  Changer changer({
      {"part_overlaps", "position", [](World& w) { bodies(w).position.z[0] += 1; }},
      {"part_overlaps", "orientation", [](World& w) { bodies(w).orientation.z[1] += 1; }},
      {"part_overlaps", "parting velocity", [](World& w) { parting_velocity(w.mutable_scratch()).z[0] += 1; }},
      {"part_overlaps", "parting spin", [](World& w) { parting_spin(w.mutable_scratch()).x[1] += 1; }},
      {"part_overlaps", "velocity", [](World& w) { body(w).velocity.z() += 1; }},
      {"part_overlaps", "spin", [](World& w) { body(w).spin.y() += 1; }},
      {"part_overlaps", "separation", [](World& w) { lane(point(w).separation) += 1; }},
  });
  advance(world, &changer);
  changer.expect_all_tried();
}

// Masses of a hard island's contacts are computed anew when its bars have turned.
TEST(PhaseHashes, CoverMassesThatTurningRenews) {
  const auto hard = [](World& world) -> ContactBatch& {
    LargeVector<ContactBatch>& all = world.mutable_scratch().contact_batches.batches;
    return *std::ranges::find_if(all, [](const ContactBatch& batch) { return batch.hard; });
  };
  SceneDef scene = test::plates_and_bars(12, 5);
  scene.world.method = Method::kLayered;
  World world = test::made(scene);
  // Up to the first step in which a bar touches something.
  const auto touches_next = [](World next) {
    advance(next);
    return std::ranges::any_of(next.scratch().contact_batches.batches, &ContactBatch::hard);
  };
  for (int k = 0; k < 300 && !touches_next(world); ++k) advance(world);
  ASSERT_TRUE(touches_next(world));
  Changer changer({
      {"integrate_positions", "response", [=](World& w) { lane(hard(w).response[5]) += 1; }},
      {"integrate_positions", "mass",
       [=](World& w) { lane(w.mutable_scratch().contact_batches.points[hard(w).first].mass) += 1; }},
  });
  advance(world, &changer);
  changer.expect_all_tried();
}

// Bodies that fall asleep are stopped.
TEST(PhaseHashes, CoverWhatFallingAsleepWrites) {
  for (const Method method : {Method::kThesis, Method::kLayered}) {
    SceneDef scene = test::on_ground();
    scene.world.method = method;
    scene.world.freeze_time = 0.05;
    scene.boxes = {test::cube(1, {0, 0, 0.5})};
    World world = test::made(scene);
    for (int k = 0; k < 60 && world.bodies().frozen[0] == 0; ++k) {
      Changer changer({{method == Method::kThesis ? "update_freezing" : "update_sleeping", "velocity", [](World& w) {
                          if (bodies(w).frozen[0] == 0) bodies(w).low_energy_time[0] += 1;
                          if (bodies(w).frozen[0] != 0) bodies(w).velocity.z[0] += 1;
                        }}});
      advance(world, &changer);
    }
    EXPECT_EQ(world.bodies().frozen[0], 1);
  }
}

// Manifolds are made once more when somebody wakes, by another phase than the one that makes them first.
TEST(PhaseHashes, WakingCoversTheManifoldsThatItMakesAnew) {
  SceneDef scene = test::tower(3);
  scene.world.method = Method::kLayered;
  test::freeze_all(scene);
  test::add_thrown_cube(scene);
  World world = test::made(scene);
  bool woke = false;
  for (int k = 0; k < 200 && !woke; ++k) {
    Changer changer({{"wake_islands", "separation", [](World& w) {
                        if (!w.scratch().found_again) bodies(w).frozen[0] ^= 1;
                        manifold_point(w).separation += 1;
                      }}});
    advance(world, &changer);
    woke = world.scratch().found_again;
  }
  EXPECT_TRUE(woke);
}

}  // namespace
}  // namespace tumble::sim
