#include "golden/hunt/scene/arrangements.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tumble::hunt {
namespace {

using sim::BoxDef;
using sim::Vec3;

// Numbers are drawn in an order that the language fixes: in statements of their own and within braces.

// Adds a box of some density between wood and iron.
BoxDef& add(sim::SceneDef& scene, Draws& draws, const Vec3& size, const Vec3& position) {
  BoxDef box;
  box.id = scene.boxes.empty() ? 1 : scene.boxes.back().id + 1;
  box.size = size;
  box.mass = draws.uniform(300, 3000) * size.x() * size.y() * size.z();
  box.position = position;
  box.material = scene.world.ground_material;
  scene.boxes.push_back(box);
  return scene.boxes.back();
}

Vec3 any_size(Draws& draws) {
  const double x = draws.uniform(0.25, 1.5), y = draws.uniform(0.25, 1.5), z = draws.uniform(0.25, 1.5);
  return draws.chance(0.25) ? Vec3(x, x, x) : Vec3(x, y, z);
}

double half_diagonal(const Vec3& size) { return 0.5 * size.norm(); }

// Spins about an own axis, or about any.
void spin(BoxDef& box, Draws& draws, double speed) {
  const Vec3 axis =
      draws.chance(0.5) ? draws.direction() : sim::axes_of(box.orientation)[static_cast<int>(draws.below(3))];
  box.spin = axis * (speed / axis.norm());
}

}  // namespace

void arrange_stack(sim::SceneDef& scene, Draws& draws) {
  const std::uint64_t count = 1 + draws.below(7);
  const bool exact = draws.chance(0.5);  // else the boxes stand a little apart, and off the middle
  const Vec3 first = any_size(draws);
  double top = 0;
  for (std::uint64_t k = 0; k < count; ++k) {
    const Vec3 size = draws.chance(0.6) ? first : Vec3(any_size(draws));
    const double off = exact ? 0 : 0.15 * std::min(size.x(), size.y());
    const double x = draws.uniform(-off, off), y = draws.uniform(-off, off);
    const double apart = exact ? 0 : draws.uniform(0, 0.01);
    add(scene, draws, size, {x, y, top + apart + 0.5 * size.z()});
    top += apart + size.z();
  }
}

void arrange_wall(sim::SceneDef& scene, Draws& draws) {
  const std::uint64_t courses = 2 + draws.below(3), bricks = 2 + draws.below(2);
  const double gap = draws.chance(0.5) ? 0 : draws.uniform(0, 0.05);
  const bool frozen = draws.chance(0.5);
  for (std::uint64_t row = 0; row < courses; ++row) {
    for (std::uint64_t k = 0; k < bricks; ++k) {
      const double x = (2 + gap) * static_cast<double>(k) + (row % 2 == 0 ? 0 : 0.75);
      add(scene, draws, {2, 1, 1}, {x, 0, 0.5 + static_cast<double>(row)}).frozen = frozen;
    }
  }
}

void arrange_heap(sim::SceneDef& scene, Draws& draws) {
  const std::uint64_t count = 2 + draws.below(9);
  double z = 0.2;
  for (std::uint64_t k = 0; k < count; ++k) {
    const Vec3 size = any_size(draws);
    z += half_diagonal(size);
    const double x = draws.uniform(-0.5, 0.5), y = draws.uniform(-0.5, 0.5);
    BoxDef& box = add(scene, draws, size, {x, y, z});
    z += half_diagonal(size) * draws.uniform(0.8, 1.1);
    if (draws.chance(0.8)) box.orientation = draws.rotation();
    if (draws.chance(0.5)) box.velocity = draws.vector(3);
    if (draws.chance(0.5)) box.spin = draws.vector(6);
  }
}

void arrange_throw(sim::SceneDef& scene, Draws& draws) {
  draws.chance(0.5) ? arrange_stack(scene, draws) : arrange_wall(scene, draws);
  const Vec3 size = any_size(draws);
  const double distance = draws.uniform(4, 8), speed = draws.magnitude(2, 6);
  const double x = draws.uniform(-0.5, 1.5), height = draws.uniform(1, 3);
  BoxDef& box = add(scene, draws, size, {x, -distance, height});
  box.velocity = {draws.uniform(-0.5, 0.5), speed, draws.uniform(-1, 2)};
  box.orientation = draws.rotation();
  spin(box, draws, draws.magnitude(-2, 4));
  if (draws.chance(0.5)) return;
  const sim::Throw thrown{box};
  scene.boxes.pop_back();
  scene.inputs.push_back({1 + draws.below(20), thrown});
}

void arrange_slope(sim::SceneDef& scene, Draws& draws) {
  sim::Material& material = scene.world.ground_material;
  material.friction = draws.uniform(0, 1);
  material.friction_dynamic = draws.chance(0.3) ? material.friction : draws.uniform(0, material.friction);
  material.restitution = draws.uniform(0, 0.8);
  const double rise = draws.uniform(0.05, 1), run = draws.uniform(-1, 1),
               side = std::sqrt(1 - std::min(1.0, run * run));
  const double root = std::sqrt(1 + rise * rise);
  const double height = draws.uniform(0.1, 1);
  const double length = height * draws.uniform(2, 4), width = height * draws.uniform(2, 4);
  const Vec3 size(length, width, height);
  if (draws.chance(0.6)) {  // gravity leans, over flat ground
    const Vec3 down(run, side, 0);
    scene.world.gravity = (down * rise - Vec3(0, 0, 1)) * (9.81 / root);
    BoxDef& box = add(scene, draws, size, {0, 0, 0.5 * height});
    if (draws.chance(0.5)) box.velocity = down * draws.uniform(0.2, 3);
    return;
  }
  // A static box leans about y by twice the half angle.
  const double half = draws.uniform(0.05, 0.4);
  const sim::Quat turn = sim::normalised({1, 0, half, 0});
  const sim::Axes axes = sim::axes_of(turn);
  scene.world.ground = draws.chance(0.5);
  BoxDef& ramp = add(scene, draws, {80, 6, 2}, Vec3(0, 0, 40) - axes[2]);
  ramp.is_static = true;
  ramp.orientation = turn;
  for (std::uint64_t k = 1 + draws.below(2); k > 0; --k) {
    const double along = 30.0 - 3 * size.x() * static_cast<double>(k);
    BoxDef& box = add(scene, draws, size, Vec3(0, 0, 40) - axes[0] * along + axes[2] * (0.5 * height));
    box.orientation = turn;
  }
}

void arrange_spinners(sim::SceneDef& scene, Draws& draws) {
  if (draws.chance(0.5)) scene.world.gravity = {0, 0, 0};
  const std::uint64_t count = 1 + draws.below(3);
  for (std::uint64_t k = 0; k < count; ++k) {
    const Vec3 place(30 * static_cast<double>(k), 0, 0);
    Vec3 size = any_size(draws);
    if (draws.chance(0.3)) size = {draws.magnitude(-4, -2), draws.magnitude(-4, -2), draws.magnitude(-1, 2)};
    const bool in_air = draws.chance(0.5);
    const double near = half_diagonal(size) * draws.uniform(0.9, 1.02);
    BoxDef& box = add(scene, draws, size, place + Vec3(0, 0, (in_air ? 20 : 0) + near));
    if (draws.chance(0.7)) box.orientation = draws.rotation();
    spin(box, draws, draws.magnitude(2, 9));
    if (draws.chance(0.5)) box.velocity = {draws.uniform(-10, 10), draws.uniform(-10, 10), draws.uniform(-1, 1)};
    if (!in_air) continue;
    const Vec3 other = any_size(draws);
    const Vec3 from = box.position, velocity = box.velocity;
    const double apart = near + half_diagonal(other) * draws.uniform(0.6, 1.02);
    const Vec3 direction = draws.direction();
    BoxDef& beside = add(scene, draws, other, from + direction * (apart / direction.norm()));
    beside.orientation = draws.rotation();
    beside.velocity = velocity;
    if (draws.chance(0.5)) spin(beside, draws, draws.magnitude(2, 8));
  }
}

void arrange_ratios(sim::SceneDef& scene, Draws& draws) {
  const std::uint64_t count = 2 + draws.below(4);
  const bool tall = draws.chance(0.6);  // one above the other, else side by side
  double along = 0.01;
  for (std::uint64_t k = 0; k < count; ++k) {
    const double edge = draws.magnitude(-6, 3);
    Vec3 size(edge, edge, edge);
    if (draws.chance(0.6)) size = {edge * draws.magnitude(-4, 1), edge * draws.magnitude(-4, 1), edge};
    const double half = 0.5 * size.z();
    along += half;
    BoxDef& box = add(scene, draws, size, tall ? Vec3(0, 0, along) : Vec3(along, 0, half + 0.01));
    along += (tall ? half : size.x()) + draws.uniform(0, 0.05);
    if (draws.chance(0.5)) box.mass = draws.magnitude(-10, 14);
    if (draws.chance(0.2)) box.orientation = draws.rotation();
    if (draws.chance(0.3)) {
      const Vec3 direction = draws.direction();
      box.velocity = direction * (draws.magnitude(-2, 7) / direction.norm());
    }
  }
}

void arrange_flight(sim::SceneDef& scene, Draws& draws) {
  scene.world.ground = false;
  if (draws.chance(0.3)) scene.world.gravity = {0, 0, 0};
  const std::uint64_t count = 1 + draws.below(3);
  for (std::uint64_t k = 0; k < count; ++k) {
    const double far = 1000 * static_cast<double>(k), x = draws.uniform(-5, 5);
    BoxDef& box = add(scene, draws, any_size(draws), {x + far, 0, 100});
    box.orientation = draws.rotation();
    box.velocity = draws.vector(20);
    spin(box, draws, draws.magnitude(-2, 8));
  }
}

void arrange_ties(sim::SceneDef& scene, Draws& draws) {
  const std::array places = {-1.0, -0.5, 0.0, 0.5, 1.0}, heights = {0.25, 0.5, 1.0, 1.5, 2.0};
  const std::array edges = {0.5, 1.0};
  const double half_root = std::sqrt(0.5);
  const std::uint64_t count = 3 + draws.below(8);
  for (std::uint64_t k = 0; k < count; ++k) {
    const double sx = draws.one_of(edges), sy = draws.one_of(edges), sz = draws.one_of(edges);
    const double x = draws.one_of(places), y = draws.one_of(places), z = draws.one_of(heights);
    BoxDef& box = add(scene, draws, {sx, sy, sz}, {x, y, z});
    box.mass = draws.chance(0.7) ? 1 : 2;
    const std::uint64_t axis = draws.below(6);
    if (axis == 0) box.orientation = {half_root, half_root, 0, 0};
    if (axis == 1) box.orientation = {half_root, 0, half_root, 0};
    if (axis == 2) box.orientation = {half_root, 0, 0, half_root};
    if (draws.chance(0.1)) box.is_static = true;
    if (!box.is_static && draws.chance(0.2)) box.frozen = true;
    if (!box.is_static && !box.frozen && draws.chance(0.5))
      box.velocity = {draws.one_of(places), draws.one_of(places), 0};
  }
}

void arrange_collisions(sim::SceneDef& scene, Draws& draws) {
  scene.world.ground = false;
  if (draws.chance(0.7)) scene.world.gravity = {0, 0, 0};
  const std::uint64_t count = 2 + draws.below(3);
  for (std::uint64_t k = 0; k < count; ++k) {
    const Vec3 size = any_size(draws), direction = draws.direction();
    const double ahead = k == 0 ? 0 : 2.5 + draws.uniform(0, 1.5);
    const Vec3 place = direction * (ahead / direction.norm());
    BoxDef& box = add(scene, draws, size, place + Vec3(0, 0, 100));
    if (draws.chance(0.7)) box.orientation = draws.rotation();
    if (k > 0) box.velocity = place * -draws.magnitude(-1, 4);
    box.velocity += draws.vector(0.3);
    if (draws.chance(0.5)) spin(box, draws, draws.magnitude(-2, 5));
  }
}

void arrange_overlaps(sim::SceneDef& scene, Draws& draws) {
  const std::uint64_t count = 2 + draws.below(4);
  for (std::uint64_t k = 0; k < count; ++k) {
    const Vec3 size = any_size(draws);
    const double x = draws.uniform(-0.6, 0.6), y = draws.uniform(-0.6, 0.6), z = draws.uniform(0.2, 2);
    BoxDef& box = add(scene, draws, size, {x, y, z});
    if (draws.chance(0.6)) box.orientation = draws.rotation();
    box.is_static = draws.chance(0.2);
  }
}

void arrange_drop(sim::SceneDef& scene, Draws& draws) {
  scene.world.ground_material.restitution = draws.uniform(0, 1);
  const Vec3 size = any_size(draws);
  BoxDef& box = add(scene, draws, size, {0, 0, 0.5 * size.z() + draws.uniform(0.3, 2)});
  if (draws.chance(0.3)) box.velocity = {draws.uniform(-2, 2), draws.uniform(-2, 2), 0};
}

}  // namespace tumble::hunt
