#include "tests/support/sim_scenes.h"

#include <cmath>
#include <stdexcept>

namespace tumble::test {

using sim::BodyId;
using sim::BoxDef;
using sim::Quat;
using sim::SceneDef;
using sim::Vec3;

namespace {

BodyId next_id(const SceneDef& scene) { return scene.boxes.empty() ? 1 : scene.boxes.back().id + 1; }

void add_cube(SceneDef& scene, const Vec3& position) { scene.boxes.push_back(cube(next_id(scene), position)); }

}  // namespace

std::uint64_t Random::next() {
  state_ += 0x9e3779b97f4a7c15ULL;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

double Random::uniform(double low, double high) {
  return low + (high - low) * (static_cast<double>(next() >> 11U) * 0x1p-53);
}

Vec3 random_vector(Random& random, double limit) {
  const double x = random.uniform(-limit, limit);
  const double y = random.uniform(-limit, limit);
  const double z = random.uniform(-limit, limit);
  return {x, y, z};
}

Quat Random::rotation() {
  const Vec3 v = random_vector(*this, 1);
  return {uniform(0.1, 1), v.x(), v.y(), v.z()};
}

BoxDef cube(BodyId id, const Vec3& position) {
  BoxDef made;
  made.id = id;
  made.position = position;
  return made;
}

BoxDef box(BodyId id, const Vec3& size, const Vec3& position) {
  BoxDef made = cube(id, position);
  made.size = size;
  made.mass = 1000 * size.x() * size.y() * size.z();
  return made;
}

Quat turn(const Vec3& axis, double cosine, double sine) {
  // Half angles: 2 cos² = 1 + cos, 2 sin² = 1 − cos.
  const double c = std::sqrt((1 + cosine) / 2);
  const double s = c > 0 ? sine / (2 * c) : 1;
  return {c, axis.x() * s, axis.y() * s, axis.z() * s};
}

SceneDef empty_space() {
  SceneDef scene;
  scene.world.method = sim::Method::kThesis;
  scene.world.gravity = Vec3::Zero();
  scene.world.ground = false;
  scene.world.freezing = false;
  scene.world.substeps = 1;
  return scene;
}

SceneDef on_ground() {
  SceneDef scene;
  scene.world.method = sim::Method::kThesis;
  scene.world.substeps = 1;
  return scene;
}

SceneDef tilted_grid(std::uint32_t n) {
  SceneDef scene = on_ground();
  const double half_root = std::sqrt(0.5);
  for (std::uint32_t r = 0; r < n; ++r) {
    for (std::uint32_t c = 0; c < n; ++c) {
      const double along = 1.25 * half_root * r;
      add_cube(scene, {(c - (n - 1) / 2.0) * 1.25, along, 0.5 + half_root + along});
      scene.boxes.back().orientation = turn({1, 0, 0}, half_root, half_root);
    }
  }
  return scene;
}

SceneDef tower(std::uint32_t count) {
  SceneDef scene = on_ground();
  for (std::uint32_t k = 0; k < count; ++k) add_cube(scene, {0, 0, 0.5 + k});
  return scene;
}

SceneDef pyramid(std::uint32_t base) {
  SceneDef scene = on_ground();
  for (std::uint32_t row = 0; row < base; ++row) {
    const std::uint32_t count = base - row;
    for (std::uint32_t c = 0; c < count; ++c) add_cube(scene, {(c - (count - 1) / 2.0) * 1.05, 0, 0.5 + row});
  }
  return scene;
}

SceneDef wall(std::uint32_t courses, std::uint32_t bricks) {
  SceneDef scene = on_ground();
  for (std::uint32_t course = 0; course < courses; ++course) {
    for (std::uint32_t k = 0; k < bricks; ++k) {
      add_cube(scene, {(k - (bricks - 1) / 2.0) * 2.02 + (course % 2 == 0 ? -0.5 : 0.5), 0, 0.5 + course});
      scene.boxes.back().size = {2, 1, 1};
      scene.boxes.back().mass = 2;
    }
  }
  return scene;
}

SceneDef pile(std::uint32_t n) {
  SceneDef scene = on_ground();
  for (std::uint32_t z = 0; z < n; ++z) {
    for (std::uint32_t y = 0; y < n; ++y) {
      for (std::uint32_t x = 0; x < n; ++x) {
        add_cube(scene, {(x - (n - 1) / 2.0) * 1.1, (y - (n - 1) / 2.0) * 1.1, 1 + z * 1.1});
      }
    }
  }
  return scene;
}

SceneDef tumble_of_boxes(std::uint32_t n, std::uint64_t seed) {
  SceneDef scene = pile(n);
  Random random(seed);
  for (BoxDef& b : scene.boxes) {
    b.position = {b.position.x() * 1.3, b.position.y() * 1.3, b.position.z() * 1.3};
    b.size = Vec3(0.7, 0.7, 0.7) + random_vector(random, 0.4);
    b.mass = random.uniform(0.2, 5);
    b.orientation = random.rotation();
    b.velocity = random_vector(random, 4);
    b.spin = random_vector(random, 6);
  }
  return scene;
}

SceneDef size_ratio() {
  SceneDef scene = on_ground();
  double x = 0;
  for (std::uint32_t k = 0; k < 19; ++k) {
    const double edge = 0.1 * std::pow(25.0, k / 18.0);
    x += edge;
    const double y = k % 3 == 0 ? 0.02 : k % 3 == 1 ? -0.03 : 0.3;
    scene.boxes.push_back(box(k + 1, {edge, edge, edge}, {0.25 * x * (k % 2 == 0 ? 1 : -1), y, 0.4 + edge + x}));
  }
  return scene;
}

SceneDef plates_and_bars(std::uint32_t count, std::uint64_t seed) {
  SceneDef scene = on_ground();
  Random random(seed);
  for (std::uint32_t k = 0; k < count; ++k) {
    const Vec3 size = k % 2 == 0 ? Vec3(2, 1.5, 0.05) : Vec3(0.1, 3, 0.12);
    BoxDef b = box(k + 1, size, {random.uniform(-1, 1), random.uniform(-1, 1), 1 + 0.5 * k});
    b.orientation = random.rotation();
    scene.boxes.push_back(b);
  }
  return scene;
}

SceneDef ramp(std::uint32_t count, std::uint64_t seed) {
  SceneDef scene = on_ground();
  Random random(seed);
  BoxDef slope = box(1, {8, 6, 1}, {0.5, 0.25, 2});
  slope.is_static = true;
  slope.orientation = {1, 0.05, 0.18, 0.02};
  scene.boxes.push_back(slope);
  for (std::uint32_t k = 0; k < count; ++k) {
    BoxDef b = box(k + 2, {0.6, 0.5, 0.4}, {random.uniform(-2, 2), random.uniform(-2, 2), 4 + 0.5 * k});
    b.orientation = random.rotation();
    scene.boxes.push_back(b);
  }
  return scene;
}

void jitter(SceneDef& scene, double amount, std::uint64_t seed) {
  Random random(seed);
  for (BoxDef& b : scene.boxes) {
    b.position.x() += random.uniform(-amount, amount);
    b.position.y() += random.uniform(-amount, amount);
    b.orientation.z += random.uniform(-amount, amount);
  }
}

void freeze_all(SceneDef& scene) {
  for (BoxDef& b : scene.boxes) b.frozen = true;
}

void add_thrown_cube(SceneDef& scene) {
  BoxDef thrown = cube(next_id(scene), {0.3, -8, 3});
  thrown.size = {2, 2, 2};
  thrown.mass = 20;
  thrown.velocity = {0.5, 25, 2};
  thrown.spin = {1, 0.5, -2};
  scene.boxes.push_back(thrown);
}

sim::World made(const SceneDef& scene) {
  Result<sim::World> world = sim::create_world(scene);
  if (!world.ok()) throw std::runtime_error(world.error().message);
  return *std::move(world);
}

sim::StepCounters advance(sim::World& world, sim::Observer* observer) {
  const Result<sim::StepCounters> counters = sim::step(world, observer);
  if (!counters.ok()) throw std::runtime_error(counters.error().message);
  return *counters;
}

sim::World after_steps(const sim::SceneDef& scene, int steps) {
  sim::World world = made(scene);
  for (int k = 0; k < steps; ++k) advance(world);
  return world;
}

void give(sim::World& world, const sim::Command& command) {
  if (const Status status = sim::apply(world, command); !status.ok()) throw std::runtime_error(status.error().message);
}

std::vector<std::uint64_t> phase_words_of(sim::World& world, int steps) {
  std::vector<std::uint64_t> all;
  for (int k = 0; k < steps; ++k) {
    sim::PhaseHashes hashes;
    advance(world, &hashes);
    all.insert(all.end(), hashes.words().begin(), hashes.words().end());
  }
  return all;
}

}  // namespace tumble::test
