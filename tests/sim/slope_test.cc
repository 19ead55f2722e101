// Coulomb on slopes (thesis III.B.2), both methods, against the closed form. A crate twice as long as high lies on a
// slope: where tan θ is below μs the crate stays and falls asleep; elsewhere it slides with g (sin θ − μd cos θ).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::Method;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

constexpr double kGravity = 9.81, kSeconds = 2;

struct Slope {
  Method method = Method::kThesis;
  double degrees = 20, friction = 0.6, friction_dynamic = 0.2;
  double dt = 1.0 / 60;
  std::uint32_t substeps = 8;
  double speed = 0;  // m/s at the start, down the slope
  double restitution = 0;
  Vec3 size = {1, 1, 0.5};
  bool box = false;    // a static box is tilted; otherwise gravity over flat ground
  double azimuth = 0;  // degrees; where "down" points to, seen from above; for tilted gravity
};

std::ostream& operator<<(std::ostream& out, const Slope& s) {
  return out << (s.method == Method::kThesis ? "thesis" : "layered") << (s.box ? ", tilted box" : ", tilted gravity")
             << ", " << s.degrees << " deg towards " << s.azimuth << ", static " << s.friction << ", dynamic "
             << s.friction_dynamic << ", dt 1/" << 1 / s.dt << ", substeps " << s.substeps << ", speed " << s.speed
             << ", restitution " << s.restitution << ", size " << s.size.transpose();
}

double radians(double degrees) { return degrees * (3.14159265358979323846 / 180); }

// The direction down the slope.
Vec3 downhill(const Slope& s) {
  const double a = radians(s.azimuth), t = radians(s.degrees);
  return s.box ? Vec3(std::cos(t), 0, -std::sin(t)) : Vec3(std::cos(a), std::sin(a), 0);
}

// Crates far apart, each alone with the ground: two collisions at once are more than split_collisions, so method thesis
// halves its steps.
SceneDef on_tilted_ground(const Slope& s, int crates) {
  SceneDef scene = on_ground();
  const double t = radians(s.degrees);
  const Vec3 down = downhill(s);
  scene.world.gravity = down * (kGravity * std::sin(t)) - Vec3(0, 0, kGravity * std::cos(t));
  for (int k = 0; k < crates; ++k) {
    scene.boxes.push_back(box(static_cast<sim::BodyId>(k) + 1, s.size, {0, 100.0 * k, 0.5 * s.size.z()}));
    scene.boxes.back().velocity = down * s.speed;
  }
  return scene;
}

SceneDef on_tilted_box(const Slope& s) {
  SceneDef scene = on_ground();
  scene.world.ground = false;
  const double t = radians(s.degrees);
  const Vec3 down = downhill(s), up(std::sin(t), 0, std::cos(t));
  scene.boxes = {box(1, {80, 6, 2}, up * -1.0), box(2, s.size, down * -30.0 + up * (0.5 * s.size.z()))};
  scene.boxes[0].is_static = true;
  for (sim::BoxDef& b : scene.boxes) b.orientation = turn({0, 1, 0}, std::cos(t), std::sin(t));
  scene.boxes[1].velocity = down * s.speed;
  return scene;
}

SceneDef scene_of(const Slope& s) {
  SceneDef scene = s.box ? on_tilted_box(s) : on_tilted_ground(s, s.method == Method::kThesis ? 2 : 1);
  scene.world.method = s.method;
  scene.world.dt = s.dt;
  scene.world.substeps = s.substeps;
  const sim::Material material = {s.friction, s.friction_dynamic, s.restitution};
  scene.world.ground_material = material;
  for (sim::BoxDef& b : scene.boxes) b.material = material;
  return scene;
}

// Metres down the slope by Coulomb; whether the crate is at rest in the end.
struct Way {
  double metres = 0;
  bool rests = false;
};
Way coulomb(const Slope& s, double seconds) {
  const double t = radians(s.degrees);
  if (s.speed == 0 && std::tan(t) < s.friction) return {0, true};
  const double gain = kGravity * (std::sin(t) - s.friction_dynamic * std::cos(t));
  const double stop = gain < 0 ? -s.speed / gain : seconds;
  const double moving = std::min(seconds, stop);
  return {s.speed * moving + 0.5 * gain * moving * moving, stop < seconds - 0.7};
}

// m that method layered falls short of: it moves a body by its speed at the end of a substep, and static friction holds
// a body that it can stop within one substep.
double stops_early(const Slope& s, const Way& wanted) {
  const double h = s.dt / s.substeps, t = radians(s.degrees);
  const double braking = kGravity * (s.friction_dynamic * std::cos(t) - std::sin(t));
  const double held = (s.friction * std::cos(t) - std::sin(t)) * kGravity * h;  // m/s
  const bool few = s.substeps < 4;
  return 0.5 * s.speed * h + (few && wanted.rests && s.speed > 0 ? held * held / (2 * braking) : 0);
}

void expect_coulomb(const Slope& s) {
  World world = made(scene_of(s));
  const sim::BodyIndex i = s.box ? 1 : 0;
  const Vec3 start = world.bodies().position[i];
  const int steps = static_cast<int>(std::lround(kSeconds / s.dt));
  for (int k = 0; k < steps; ++k) advance(world);
  const Way wanted = coulomb(s, steps * s.dt);
  const Vec3 moved = world.bodies().position[i] - start, down = downhill(s);
  const double early = s.method == Method::kThesis ? 0 : stops_early(s, wanted);
  EXPECT_LT((moved - down * wanted.metres).norm(), std::max(0.001, 0.02 * wanted.metres) + early)
      << moved.dot(down) << " m down the slope, not " << wanted.metres << ": " << s;
  EXPECT_TRUE(!wanted.rests || world.bodies().frozen[i] != 0) << s;
}

// Slopes so near to the limit that the least error tips them are left out.
bool clear_cut(const Slope& s) {
  const double slope = std::tan(radians(s.degrees)), clear = 0.02;
  return std::fabs(slope - s.friction) >= clear && (s.speed == 0 || std::fabs(slope - s.friction_dynamic) >= clear);
}

void expect_coulomb_on_grid(Method method, bool box) {
  for (const double degrees : {5.0, 20.0, 32.0, 45.0}) {
    for (const auto& [fixed, sliding] : {std::pair(0.0, 0.0), {0.2, 0.1}, {0.6, 0.2}, {0.6, 0.6}, {1.0, 0.0}}) {
      for (const double dt : {1.0 / 30, 1.0 / 60, 1.0 / 1000}) {
        for (const std::uint32_t substeps : {1U, 8U, 64U}) {
          if (dt < 0.002 && substeps != 8) continue;  // FinestSubsteps has more
          Slope s{method, degrees, fixed, sliding, dt, substeps};
          s.box = box;
          if (clear_cut(s)) expect_coulomb(s);
        }
      }
    }
  }
}

TEST(Slope, ThesisOnTiltedGround) { expect_coulomb_on_grid(Method::kThesis, false); }
TEST(Slope, ThesisOnATiltedBox) { expect_coulomb_on_grid(Method::kThesis, true); }
TEST(Slope, LayeredOnTiltedGround) { expect_coulomb_on_grid(Method::kLayered, false); }
TEST(Slope, LayeredOnATiltedBox) { expect_coulomb_on_grid(Method::kLayered, true); }

// Crates that touch one another rest as each would alone.
TEST(Slope, ThesisRowOfCratesStaysAndFreezes) {
  for (const double gap : {0.0, 1e-4, 0.05}) {
    for (const double dt : {1.0 / 30, 1.0 / 60, 1.0 / 240}) {
      Slope s;
      s.dt = dt;
      s.size = {1, 0.8, 0.4};
      SceneDef scene = scene_of(s);
      scene.boxes.resize(1);
      for (const int k : {1, 2}) {
        scene.boxes.push_back(scene.boxes[0]);
        scene.boxes.back().id += static_cast<sim::BodyId>(k);
        scene.boxes.back().position.x() += k * (s.size.x() + gap);
      }
      World world = made(scene);
      for (int k = 0; k * dt < kSeconds; ++k) advance(world);
      for (sim::BodyIndex i = 0; i < 3; ++i) {
        EXPECT_LT((world.bodies().position[i] - scene.boxes[i].position).norm(), 0.001) << "gap " << gap << ", " << s;
        EXPECT_NE(world.bodies().frozen[i], 0) << "gap " << gap << ", " << s;
      }
    }
  }
}

TEST(Slope, FinestSubsteps) {
  for (const Method method : {Method::kThesis, Method::kLayered}) {
    for (const double degrees : {20.0, 40.0}) expect_coulomb({method, degrees, 0.6, 0.2, 1.0 / 1000, 64});
  }
}

Slope random_slope(Method method, Random& random) {
  Slope s;
  s.method = method;
  do {
    s.degrees = random.uniform(5, 45);
    s.friction = random.uniform(0, 1);
    s.friction_dynamic = random.uniform(0, s.friction);
    s.speed = random.uniform(0, 1) < 0.5 ? 0 : random.uniform(0.2, 3);
  } while (!clear_cut(s));
  s.dt = 1 / std::floor(std::exp(random.uniform(std::log(30.0), std::log(1000.0))));
  s.substeps = 1U << (random.next() % 7);
  if (s.dt < 0.004) s.substeps = std::min(s.substeps, 8U);  // for time; FinestSubsteps has more
  s.restitution = random.uniform(0, 0.8);
  s.box = random.uniform(0, 1) < 0.4;
  s.azimuth = random.uniform(0, 360);
  const double height = random.uniform(0.1, 1);
  s.size = {height * random.uniform(2, 4), height * random.uniform(2, 4), height};
  return s;
}

void expect_coulomb_on_random_slopes(Method method) {
  Random random(16);
  for (int k = 0; k < 300; ++k) expect_coulomb(random_slope(method, random));
}

TEST(Slope, ThesisOnRandomSlopes) { expect_coulomb_on_random_slopes(Method::kThesis); }
TEST(Slope, LayeredOnRandomSlopes) { expect_coulomb_on_random_slopes(Method::kLayered); }

}  // namespace
}  // namespace tumble::test
