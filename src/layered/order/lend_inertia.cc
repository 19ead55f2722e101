#include "src/layered/order/lend_inertia.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <utility>

#include "src/layered/order/contact_graph.h"

namespace tumble::sim {
namespace {

using Support = WeightScratch::Support;

std::span<const Support> supports_of(const WeightScratch& own, BodyIndex i) {
  return std::span(own.supports).subspan(own.start[i], own.start[i + 1] - own.start[i]);
}

using SupportPoint = WeightScratch::SupportPoint;

// Whether a line through (x, y) has all points on one side of it. If so, one through a point has: all others lie
// clockwise of it, or all lie counterclockwise.
bool all_on_one_side(std::span<const SupportPoint> points, double x, double y) {
  return std::ranges::any_of(points, [&](const SupportPoint& first) {
    const double first_x = first.x - x, first_y = first.y - y;
    bool left = true, right = true;
    for (const SupportPoint& other : points) {
      const double other_x = other.x - x, other_y = other.y - y;
      const double turn = first_x * other_y - first_y * other_x;
      if (turn == 0 && first_x * other_x + first_y * other_y <= 0) return false;  // opposite, or at the place itself
      left &= turn >= 0;
      right &= turn <= 0;
      if (!left && !right) return false;
    }
    return true;
  });
}

// The octagon whose edges lie along the axes and halfway between them: a cheap answer where it is no.
bool within_octagon(std::span<const SupportPoint> points, double x, double y) {
  constexpr int kDirections = 4;
  const double wanted[kDirections] = {x, y, x + y, x - y};
  bool below[kDirections] = {}, above[kDirections] = {};
  for (const SupportPoint& point : points) {
    const double at[kDirections] = {point.x, point.y, point.x + point.y, point.x - point.y};
    for (int k = 0; k < kDirections; ++k) {
      below[k] |= at[k] <= wanted[k];
      above[k] |= at[k] >= wanted[k];
    }
  }
  return std::ranges::all_of(below, std::identity()) && std::ranges::all_of(above, std::identity());
}

constexpr double kLittle = 1;  // m/s; a push on a body that is held gives it such a speed for a moment

// A body that leaves its supports along their normals, or tips, is not at rest on them. One that a hit drives into them
// stays on them, however fast.
bool stays_on(const Bodies& bodies, BodyIndex i, const Vec3& along) {
  const Vec3 spin = bodies.spin[i], tipping = spin - along * dot(along, spin);
  return dot(along, bodies.velocity[i]) <= kLittle &&
         dot(tipping, tipping) * dot(bodies.half_extent[i], bodies.half_extent[i]) <= kLittle * kLittle;
}

}  // namespace

bool press_between(std::span<const SupportPoint> points, double x, double y) {
  return within_octagon(points, x, y) && !all_on_one_side(points, x, y);
}

// From the ground up, then from the top down, where also the largest mass above is passed on. The caller has cleared
// held, and set offered to the masses.
void find_held(Scratch& scratch, const Waves& waves) {
  WeightScratch& own = scratch.weights;
  const Worker& worker = waves.worker();
  waves.walk_back([&](BodyIndex i) {
    const auto holds = [&](const Support& s) { return !s.bears || s.lower == kGround || own.held[s.lower] != 0; };
    own.held[i] = own.stands[i] != 0 && std::ranges::all_of(supports_of(own, i), holds) ? 1 : 0;
    own.settled[i] = own.held[i];
  });
  waves.walk_again([&](BodyIndex i) {
    const bool unsettled = own.settled[i] == 0 && own.borne[i] != 0;
    for (const Support& s : supports_of(own, i)) {
      if (s.lower == kGround) continue;
      const Worker by = who_adds(scratch.graph, s.lower, worker);
      by.raise(own.offered[s.lower], own.offered[i]);
      if (unsettled && s.bears) by.put(own.settled[s.lower], std::uint8_t{0});
    }
  });
}

bool may_start(const WeightScratch& own, const Support& support) {
  const BodyIndex upper = support.upper, lower = support.lower;
  return (lower == kGround || own.settled[lower] != 0) && (own.settled[upper] != 0 || own.borne[upper] == 0);
}

void lend_inertia(const WorldState& state, Scratch& scratch, const Waves& waves) {
  const Bodies& bodies = state.bodies;
  WeightScratch& own = scratch.weights;
  waves.for_all([&](BodyIndex i) {
    const Vec3 upward = std::exchange(upward_of(scratch)[i], Vec3::Zero());
    if (own.held[i] == 0 || own.offered[i] <= bodies.mass[i] || upward == Vec3::Zero()) return;
    const Vec3 along = upward / length(upward);
    if (!stays_on(bodies, i, along)) return;
    scratch.solver_mass[i] = own.offered[i];
    scratch.lent_along[i] = along;
  });
}

}  // namespace tumble::sim
