// Method layered: what passes freely is not hit, and what meets is hit, however fast it turns.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "src/collide/box_pair.h"
#include "src/model/mass.h"
#include "src/world/free_flight.h"
#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::BoxFrame;
using sim::Vec3;

constexpr int kWorlds = 100;
constexpr sim::BodyId kInEach = 50;  // cases against the ground, and as many against another body
constexpr int kHits = 5000;          // of each kind
constexpr int kSticks = 500;
constexpr double kTumbleMost = 0.5;  // rad in a substep
constexpr double kApart = 60;        // m between cases

Vec3 direction(Random& random) {
  const Vec3 v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  return v / v.norm();
}

// Uniform in the logarithm.
double magnitude(Random& random, double low, double high) {
  return std::exp(random.uniform(std::log(low), std::log(high)));
}

// A box that turns about one of its own axes, or a cube about any.
sim::BoxDef spinner(sim::BodyId id, Random& random) {
  const auto edge = [&] { return magnitude(random, 0.1, 5); };
  const bool even = random.uniform(0, 1) < 0.5;
  sim::BoxDef body = box(id, even ? Vec3(Vec3::Constant(edge())) : Vec3(edge(), edge(), edge()), {0, 0, 0});
  body.orientation = sim::normalised(random.rotation());
  const Vec3 axis = even ? direction(random) : sim::axes_of(body.orientation)[static_cast<int>(random.next() % 3)];
  body.spin = axis * magnitude(random, 1, 1000);
  return body;
}

// How far a corner reaches along n in a whole round about the body's spin.
double reach_in_a_round(const sim::BoxDef& body, const Vec3& n) {
  const sim::Axes axes = sim::axes_of(body.orientation);
  const Vec3 u = body.spin / body.spin.norm();
  double reach = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Vec3 c = Vec3::Zero();
    for (unsigned k = 0; k < 3; ++k)
      c += axes[static_cast<int>(k)] * ((corner >> k & 1U) != 0 ? 0.5 : -0.5) * body.size[k];
    const double along = c.dot(u), across = (c - u * along).norm(), un = u.dot(n);
    reach = std::max(reach, along * un + across * std::sqrt(std::max(0.0, 1 - un * un)));
  }
  return reach;
}

sim::SceneDef still_world(Random& random) {
  sim::SceneDef scene = on_ground();
  scene.world.method = sim::Method::kLayered;
  scene.world.gravity = {0, 0, 0};
  scene.world.freezing = false;
  scene.world.dt = magnitude(random, 1.0 / 1000, 1.0 / 30);
  scene.world.substeps = 1 + static_cast<std::uint32_t>(random.next() % 8);
  return scene;
}

Vec3 place_of(sim::BodyId k) {
  const sim::BodyId row = k / 10, column = k % 10;
  return {kApart * (static_cast<double>(column) - 5), kApart * (static_cast<double>(row) - 5), 0};
}

// Counts bodies that one step leaves with other velocities than those of a flight alone: without the ground, and with
// every other body of the scene far away.
void expect_unhit(const sim::SceneDef& scene, int& hit) {
  sim::SceneDef alone = scene;
  alone.world.ground = false;
  for (std::size_t i = 1; i < alone.boxes.size(); i += 2) alone.boxes[i].position.z() += 2000;
  sim::World world = made(scene), flights = made(alone);
  advance(world);
  advance(flights);
  const sim::Bodies &met = world.bodies(), &flown = flights.bodies();
  for (sim::BodyIndex i = 0; i < met.size(); ++i) {
    if (met.velocity[i] != flown.velocity[i] || met.spin[i] != flown.spin[i]) ++hit;
  }
}

TEST(FreePass, OverTheGroundChangesNoVelocity) {
  int hit = 0;
  for (int world = 0; world < kWorlds; ++world) {
    Random random(static_cast<std::uint64_t>(world));
    sim::SceneDef scene = still_world(random);
    for (sim::BodyId k = 0; k < kInEach; ++k) {
      sim::BoxDef body = spinner(k + 1, random);
      body.position = place_of(k);
      body.position.z() = reach_in_a_round(body, {0, 0, -1}) + magnitude(random, 0.001, 1);
      body.velocity = {random.uniform(-20, 20), random.uniform(-20, 20), 0};
      scene.boxes.push_back(body);
    }
    expect_unhit(scene, hit);
  }
  EXPECT_EQ(hit, 0) << "of " << kWorlds * kInEach;
}

TEST(FreePass, OfAnotherBodyChangesNoVelocity) {
  int hit = 0;
  for (int world = 0; world < kWorlds; ++world) {
    Random random(1000 + static_cast<std::uint64_t>(world));
    sim::SceneDef scene = still_world(random);
    for (sim::BodyId k = 0; k < kInEach; ++k) {
      sim::BoxDef a = spinner(2 * k + 1, random);
      sim::BoxDef b = spinner(2 * k + 2, random);
      const Vec3 n = direction(random);
      Vec3 across = direction(random);
      across -= n * across.dot(n);
      const double apart = reach_in_a_round(a, n) + reach_in_a_round(b, -n) + magnitude(random, 0.001, 0.3);
      a.position = place_of(k) + Vec3(0, 0, 200);
      b.position = a.position + n * apart + across * random.uniform(-1, 1);
      a.velocity = direction(random) * random.uniform(0, 5);
      b.velocity = a.velocity + across * random.uniform(-20, 20);
      scene.boxes.push_back(a);
      scene.boxes.push_back(b);
    }
    expect_unhit(scene, hit);
  }
  EXPECT_EQ(hit, 0) << "of " << 2 * kWorlds * kInEach << " bodies";
}

// A crate that stands on the ground is no free body; beside it, too, a free body flies as if alone.
TEST(FreePass, OfACrateAtRestChangesNoVelocity) {
  int hit = 0;
  for (int world = 0; world < kWorlds; ++world) {
    Random random(4000 + static_cast<std::uint64_t>(world));
    sim::SceneDef scene = still_world(random);
    scene.world.gravity = {0, 0, -9.81};
    sim::SceneDef alone = scene;
    for (sim::BodyId k = 0; k < 20; ++k) {
      sim::BoxDef body = box(2 * k + 1, Vec3::Constant(magnitude(random, 0.1, 5)), {0, 0, 0});
      body.orientation = sim::normalised(random.rotation());
      body.spin = direction(random) * magnitude(random, 1, 1000);
      sim::BoxDef crate = box(2 * k + 2, {2, 16, 30}, place_of(k) + Vec3(0, 0, 15));
      const double apart = 1 + reach_in_a_round(body, {-1, 0, 0}) + magnitude(random, 0.001, 0.05);
      body.position = crate.position + Vec3(apart, 0, random.uniform(-1, 1));
      body.velocity = {0, random.uniform(-5, 5), random.uniform(-5, 5)};
      crate.frozen = random.uniform(0, 1) < 0.3;
      scene.boxes.push_back(body);
      scene.boxes.push_back(crate);
      alone.boxes.push_back(body);
    }
    sim::World beside = made(scene), flights = made(alone);
    for (int k = 0; k < 6; ++k) {
      advance(beside);
      advance(flights);
    }
    for (sim::BodyIndex i = 0; i < flights.bodies().size(); ++i) {
      const Vec3 change = beside.bodies().velocity[2 * i] - flights.bodies().velocity[i];
      hit += change.norm() > 1e-9 ? 1 : 0;
    }
  }
  EXPECT_EQ(hit, 0) << "of " << 20 * kWorlds;
}

BoxFrame frame_of(const sim::BoxDef& body) { return {body.position, sim::axes_of(body.orientation), body.size * 0.5}; }

// The body as it flew a time ago.
void fly_back(sim::BoxDef& body, double time) {
  const Vec3 inertia = sim::box_inertia(1, body.size);
  const sim::Rotation back = sim::rotate_freely(body.orientation, body.spin, inertia, inertia.cwiseInverse(), -time);
  body.position -= body.velocity * time;
  body.orientation = back.orientation;
  body.spin = back.spin;
}

double lowest(const BoxFrame& frame) { return frame.position.z() - sim::reach_along(frame, 2); }

// A body that is in the ground at a moment of the step and clear of it at its start, or in another body.
bool make_hit(Random& random, double dt, bool ground, sim::BoxDef& a, sim::BoxDef& b) {
  const double when = random.uniform(0.1, 0.9) * dt, depth = random.uniform(0.005, 0.02) * a.size.minCoeff();
  const Vec3 n = direction(random);
  a.velocity = direction(random) * random.uniform(0, 20);
  b.velocity = direction(random) * random.uniform(0, 20);
  if (ground) {
    a.position = {0, 0, 0};
    a.position.z() = -depth - lowest(frame_of(a));
    fly_back(a, when);
    return lowest(frame_of(a)) > 0.001;
  }
  a.position = {0, 0, 200};
  b.position = a.position + n * 20;
  double near = 0, far = 20;  // along n: in touch at near
  for (int k = 0; k < 50; ++k) {
    const double middle = 0.5 * (near + far);
    b.position = a.position + n * middle;
    (sim::BoxPair(frame_of(a), frame_of(b)).best_of_all().separation > -depth ? far : near) = middle;
  }
  fly_back(a, when);
  fly_back(b, when);
  return sim::BoxPair(frame_of(a), frame_of(b)).best_of_all().separation > 0.001;
}

// Whether a step changes the velocity of the first body. A step that finds a velocity too large has changed one.
bool is_hit(const sim::SceneDef& scene) {
  sim::World world = made(scene);
  const Vec3 before = world.bodies().velocity[0];
  if (!sim::step(world).ok()) return true;
  return (world.bodies().velocity[0] - before).norm() >= 1e-9;
}

// Contacts are solved with the spin at the start of a substep. The spin of an uneven box is another by its end.
bool tumbles_fast(const sim::SceneDef& scene) {
  const double substep = scene.world.dt / scene.world.substeps;
  return std::ranges::any_of(scene.boxes, [&](const sim::BoxDef& body) {
    const bool even = body.size.x() == body.size.y() && body.size.y() == body.size.z();
    return !even && body.spin.norm() * substep > kTumbleMost;
  });
}

struct Missed {
  int slow = 0, fast = 0;  // of boxes that do not tumble fast, and that do
  int slow_hits = 0, fast_hits = 0;
};

Missed missed_hits(bool ground) {
  Missed missed;
  Random random(ground ? 2000 : 3000);
  while (missed.slow_hits < kHits) {
    sim::SceneDef scene = still_world(random);
    sim::BoxDef a = spinner(1, random), b = spinner(2, random);
    if (random.uniform(0, 1) < 0.3) a.spin = direction(random) * magnitude(random, 1, 1000);  // tumbles
    if (!make_hit(random, scene.world.dt, ground, a, b)) continue;
    scene.boxes.push_back(a);
    if (!ground) scene.boxes.push_back(b);
    const bool fast = tumbles_fast(scene), hit = is_hit(scene);
    ++(fast ? missed.fast_hits : missed.slow_hits);
    if (!hit) ++(fast ? missed.fast : missed.slow);
  }
  return missed;
}

void expect_hits(bool ground) {
  const Missed missed = missed_hits(ground);
  EXPECT_EQ(missed.slow, 0) << "of " << missed.slow_hits;
  EXPECT_LE(missed.fast, missed.fast_hits / 50) << "of " << missed.fast_hits << ": docs/step.md names the limit";
}

TEST(RealHit, OfTheGroundIsNotMissed) { expect_hits(true); }
TEST(RealHit, OfAnotherBodyIsNotMissed) { expect_hits(false); }

// A stick that lands on one corner hits with the next ones in the same step, and does not fall through the ground.
TEST(RealHit, OfAStickLetsNoOtherCornerThrough) {
  Random random(4000);
  int fallen = 0;
  for (int k = 0; k < kSticks; ++k) {
    sim::SceneDef scene = on_ground();
    scene.world.method = sim::Method::kLayered;
    scene.world.dt = 1.0 / 30;
    const Vec3 size(random.uniform(0.05, 0.2), random.uniform(0.05, 0.2), random.uniform(1, 4));
    sim::BoxDef stick = box(1, size, {0, 0, random.uniform(3, 6)});
    stick.orientation = sim::normalised(random.rotation());
    stick.spin = direction(random) * random.uniform(0, 60);
    stick.material.friction = stick.material.friction_dynamic = 0;
    stick.material.restitution = 0.6;
    scene.boxes = {stick};
    sim::World world = made(scene);
    for (int step = 0; step < 90; ++step) advance(world);
    if (world.bodies().position.z[0] < 0) ++fallen;
  }
  EXPECT_EQ(fallen, 0) << "of " << kSticks;
}

// The cube of the first report: corners pass 4.3 cm above the ground.
TEST(FreePass, OfASpinningCubeKeepsItsEnergyForSeconds) {
  sim::SceneDef scene = on_ground();
  scene.world.method = sim::Method::kLayered;
  scene.world.gravity = {0, 0, 0};
  scene.boxes = {cube(1, {0, 0, 0.75})};
  scene.boxes[0].spin = {20, 0, 0};
  sim::World world = made(scene);
  for (int k = 0; k < 300; ++k) advance(world);
  EXPECT_EQ(world.bodies().velocity[0], Vec3(0, 0, 0));
  EXPECT_EQ(world.bodies().spin[0], Vec3(20, 0, 0));
}

}  // namespace
}  // namespace tumble::test
