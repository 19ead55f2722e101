// Thesis III.C and III.E: the outcomes of all collisions are applied at one time, and together they gain no energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::BodyIndex;
using sim::BoxDef;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

double kinetic_energy(const World& world) {
  const sim::Bodies& bodies = world.bodies();
  double sum = 0;
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (bodies.is_static[i] != 0) continue;
    const Vec3 spin = sim::to_body(sim::axes_of(bodies.orientation[i]), bodies.spin[i]);
    sum += 0.5 * bodies.mass[i] * bodies.velocity[i].squaredNorm();
    sum += 0.5 * spin.cwiseProduct(spin).cwiseQuotient(Vec3(bodies.inverse_inertia[i])).sum();
  }
  return sum;
}

Vec3 momentum(const World& world) {
  const sim::Bodies& bodies = world.bodies();
  Vec3 sum = Vec3::Zero();
  for (BodyIndex i = 0; i < bodies.size(); ++i) sum += bodies.velocity[i] * bodies.mass[i];
  return sum;
}

// Cubes of 1 m overlap a little in a cluster and fly in all directions: each is in several collisions.
SceneDef cluster(Random& random, std::size_t count) {
  SceneDef scene = empty_space();
  scene.world.substeps = 1;
  const sim::Material material = {random.uniform(0, 1), 0.3, random.uniform(0, 1)};
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t row = k / 3 % 3, layer = k / 9;
    const Vec3 place(0.97 * static_cast<double>(k % 3), 0.97 * static_cast<double>(row),
                     0.97 * static_cast<double>(layer));
    const Vec3 off(random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02));
    BoxDef moving = cube(k + 1, place + off);
    moving.mass = random.uniform(0.2, 5);
    moving.velocity = {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
    moving.spin = {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
    moving.material = material;
    scene.boxes.push_back(moving);
  }
  return scene;
}

// 300 clusters of up to 27 cubes. One after another on their own, the collisions of 70 of them would gain energy.
TEST(CollisionsTogether, GainNoEnergyAndKeepMomentum) {
  Random random(3);
  for (int trial = 0; trial < 300; ++trial) {
    World world = made(cluster(random, 2 + random.next() % 26));
    const double before = kinetic_energy(world);
    const Vec3 momentum_before = momentum(world);
    advance(world);
    EXPECT_LE(kinetic_energy(world), before * (1 + 1e-6)) << "trial " << trial;
    EXPECT_LT((momentum(world) - momentum_before).norm(), 1e-9) << "trial " << trial;
  }
}

// A cube falls at 1 m/s onto the ends of two, three or four beams at once. It stops, or leaves at restitution times its
// speed, as on one beam.
TEST(CollisionsTogether, SeveralSupportsStopABodyLikeOne) {
  for (const std::size_t supports : {1U, 2U, 3U, 4U}) {
    for (const double restitution : {0.0, 0.5}) {
      SceneDef scene = empty_space();
      scene.world.substeps = 1;
      scene.world.dt = 1e-6;
      scene.boxes = {cube(1, {0, 0, 0.999})};
      scene.boxes[0].velocity = {0, 0, -1};
      for (std::size_t k = 0; k < supports; ++k) {
        const double y = supports == 1 ? 0 : -0.36 + 0.72 * static_cast<double>(k) / static_cast<double>(supports - 1);
        scene.boxes.push_back(box(k + 2, {4, 0.2, 1}, {0, y, 0}));
        scene.boxes.back().is_static = true;
      }
      for (BoxDef& b : scene.boxes) b.material = {0, 0, restitution};
      World world = made(scene);
      advance(world);
      EXPECT_NEAR(world.bodies().velocity[0].z(), restitution, 1e-9) << supports << " supports";
      EXPECT_LT(world.bodies().spin[0].norm(), 1e-9) << supports << " supports";
    }
  }
}

}  // namespace
}  // namespace tumble::test
