#include "src/layered/islands/hard_islands.h"

#include <algorithm>

#include "src/layered/find/velocity_ranges.h"
#include "src/layered/islands/awake_links.h"
#include "src/world/for_bodies.h"

namespace tumble::sim {
namespace {

constexpr double kStill = 0.01;  // m/s
constexpr double kPlate = 4;     // times as wide as thick

using Link = ContactGraph::Link;

// Whether bodies of very different masses touch and move: few sweeps leave over a part of the heavy one's impulse that
// throws the light one aside. At rest the loads that a contact starts from are all that it needs.
bool is_uneven(const Bodies& bodies, const Link& m) {
  if (at_rest(bodies, m.a) || at_rest(bodies, m.b)) return false;
  const auto [light, heavy] = std::minmax({bodies.mass[m.a], bodies.mass[m.b]});
  const Vec3 a = bodies.velocity[m.a], b = bodies.velocity[m.b];
  return heavy >= kMuchHeavier * light && std::max(dot(a, a), dot(b, b)) > kStill * kStill;
}

bool is_plate(const Scratch& scratch, BodyIndex i) {
  if (i == kGround) return false;
  const Vec3& half_extent = scratch.frames[i].half_extent;
  return half_extent.maxCoeff() >= kPlate * half_extent.minCoeff();
}

// Whether a plate may be driven into another body, or that into it, by more than half a thickness before the next step:
// what few sweeps leave over of the hit would drive a stack of plates into itself. Cubes are parted in time. Not where
// a much heavier body hits: many sweeps at the same points would add up what each of them gives the light one too much.
bool is_hit_through(const Scratch& scratch, const Link& m, double dt_s) {
  if (scratch.ranges.empty() || scratch.hit_unevenly[m.b] != 0) return false;
  if (!is_plate(scratch, m.a) && !is_plate(scratch, m.b)) return false;
  if (m.a != kGround && scratch.hit_unevenly[m.a] != 0) return false;
  return m.a == kGround ? fall_if_hit(scratch, m.b, dt_s) > 0 : way_most_if_hit(scratch, m.a, m.b, dt_s) > 0;
}

}  // namespace

std::span<const std::uint8_t> find_hard_islands(const WorldState& state, Scratch& scratch, double dt_s) {
  const Bodies& bodies = state.bodies;
  IslandScratch& own = scratch.islands;
  const auto makes_hard = [&](const Link& m) {
    return is_bar(bodies, m.a) || is_bar(bodies, m.b) || is_uneven(bodies, m) || is_hit_through(scratch, m, dt_s);
  };
  std::uint8_t any = 0;
  for_awake(scratch, [&](const Link& m) {
    if (makes_hard(m)) mark(any);
  });
  if (any == 0) return {};
  fill_bodies(scratch, bodies.size(), own.marked, std::uint8_t{0});
  own.hard.resize(bodies.size());
  for_awake(scratch, [&](const Link& m) {
    if (makes_hard(m)) mark(own.marked[own.of[mover_of(bodies, m)]]);
  });
  for_bodies(scratch, bodies.size(), [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) own.hard[i] = own.marked[own.of[i]];
  });
  return own.hard;
}

}  // namespace tumble::sim
