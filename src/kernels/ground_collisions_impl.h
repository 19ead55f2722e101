#pragma once

// Collisions with the ground for any number of lanes: the operations of collide and add_outcome in src/thesis, in their
// order. lane_vector.h says who may include this.

#include "src/kernels/ground_load_impl.h"

namespace tumble::sim {
namespace {

// As Collision, of the impulse on the ground and of the body's turn; and how they meet.
template <class V>
struct LaneCollision {
  Space<V> impulse, friction, turn;
  V approach;
  MaskOf<V> resting;
};

// The load that corners share, where they do.
template <class V>
struct LaneRest {
  LaneLoad<V> load;
  Space<V> normal_of;
  V twist, twist_yield;
};

template <class V>
LaneRest<V> find_rest(const LaneBody<V>& body, const LaneEncounter<V>& met, const LanePatch<V>& patch,
                      const Space<V>& normal, const Space<V>& spin, double slip_speed_max) {
  const V zero = V{} + 0.0;
  LaneRest<V> rest;
  LaneMeeting<V> m(body, met);
  rest.normal_of = to_body(body.frame.axes, normal);
  m.twist = dot(spin, normal);
  const auto twists = met.rough & (m.twist != 0.0);
  if (any(twists)) {
    m.radius = twists ? patch.radius(normal) : zero;
    m.twist_yield = twists ? weighted(rest.normal_of, rest.normal_of, body.inverse_inertia) : zero;
    const V at_rim = absolute(m.twist) * m.radius;
    m.slow = m.slow & ((twists == 0) | (at_rim < slip_speed_max));
  }
  rest.load = share_load(body, met, m, patch, normal, spin, rest.normal_of);
  rest.twist = m.twist;
  rest.twist_yield = m.twist_yield;
  return rest;
}

template <class V>
void keep_energy(const LaneBody<V>& body, const Space<V>& relative, LaneCollision<V>& result) {
  const V spent = -2.0 * dot(result.impulse, relative), zero = V{} + 0.0;
  const V adding = dot(result.impulse, result.impulse) * body.inverse_mass +
                   weighted(result.turn, result.turn, body.inverse_inertia);
  const V scale = adding <= spent ? V{} + 1.0 : larger(zero, spent) / adding;
  result.impulse = result.impulse * scale;
  result.friction = result.friction * scale;
  result.turn = result.turn * scale;
}

template <class V>
LaneCollision<V> collide_at(const GroundCollisions& work, const LaneBody<V>& body, std::size_t at) {
  const V zero = V{} + 0.0;
  const Space<V> none = {zero, zero, zero}, normal = {zero, zero, V{} - 1.0};
  const Space<V> gained = none - Space<V>{V{} + work.gained[0], V{} + work.gained[1], V{} + work.gained[2]};
  const LaneEncounter<V> met(body, normal, gained, work.slip_speed);
  LanePatch<V> patch(work, at);
  const MaskOf<V> meets = (met.approach >= 0.0) == 0;
  const V corners = patch.counts(), fastest_at_rest = 2.0 * dot(gained, normal);
  const MaskOf<V> may_share = meets & (corners >= 3.0) & (met.approach >= fastest_at_rest);
  const Space<V> spin = none - body.spin;
  LaneRest<V> rest = {};
  LaneCollision<V> result;
  LaneImpulses<V> impulses = {zero, zero, zero};
  result.approach = met.approach;
  result.resting = MaskOf<V>{};
  if (any(may_share)) {
    patch.take_corners(work, at);
    rest = find_rest(body, met, patch, normal, spin, work.slip_speed);
    result.resting = may_share & rest.load.found;
    impulses = rest.load.impulses;
  }
  if (any(meets & (result.resting == 0))) {
    const LaneImpulses<V> single = impulses_of(LaneMeeting<V>(body, met), met.pull, body, false);
    impulses = {result.resting ? impulses.normal : single.normal, result.resting ? impulses.friction : single.friction,
                impulses.twist};
  }
  result.friction = met.tangent * -impulses.friction;
  result.impulse = normal * impulses.normal + result.friction;
  result.turn = met.by_normal * impulses.normal - met.by_tangent * impulses.friction;
  Space<V> relative = met.relative;
  if (any(result.resting)) {
    const Space<V> shift = rest.load.shift;
    const auto shifted = result.resting & ((shift.x != 0.0) | (shift.y != 0.0) | (shift.z != 0.0));
    relative = chosen(shifted, relative + cross(spin, shift), relative);
    result.turn = chosen(shifted, to_body(body.frame.axes, cross(body.r + shift, result.impulse)), result.turn);
  }
  keep_energy(body, relative, result);
  const auto twists = result.resting & (impulses.twist > 0.0);
  if (any(twists)) {
    const V left = (rest.twist + weighted(rest.normal_of, result.turn, body.inverse_inertia)) / rest.twist_yield;
    const V low = -impulses.twist, high = impulses.twist;
    const V twist = -(left < low ? low : high < left ? high : left);
    result.turn = chosen(twists, result.turn + rest.normal_of * twist, result.turn);
  }
  result.impulse = chosen(meets, result.impulse, none);
  result.friction = chosen(meets, result.friction, none);
  result.turn = chosen(meets, result.turn, none);
  return result;
}

// Writes how the body meets the ground, and the outcome for the body, which gets the opposite of the ground's.
template <class V>
void collide_ground_at(const GroundCollisions& work, std::size_t at) {
  constexpr unsigned kGainDoubles = GroundCollisions::kGainDoubles,
                     kMaterialDoubles = GroundCollisions::kMaterialDoubles;
  constexpr unsigned kLanesHere = sizeof(V) / sizeof(double);
  const LaneBody<V> body(work, at);
  const LaneCollision<V> hit = collide_at(work, body, at);
  store_space(work.impulse, at, hit.impulse);
  const V material[kMaterialDoubles] = {body.friction, body.friction_dynamic, body.restitution, V{} + work.slip_speed};
  scatter4(work.materials + at * kMaterialDoubles, kMaterialDoubles, material);
  const V yield = -1.0 * body.inverse_mass, half_s = V{} + 0.5 * work.dt_s, opposite = V{} - 1.0, zero = V{} + 0.0;
  const Space<V> turning = scaled(hit.turn, body.inverse_inertia);
  const Space<V> velocity = on_grid(hit.impulse * yield, kMotionMagic);
  const Space<V> spin = on_grid(to_world(body.frame.axes, turning * opposite), kMotionMagic);
  const Space<V> slowed = on_grid(hit.friction * yield, kMotionMagic);
  const Space<V> way_back = chosen(hit.resting, on_grid(slowed * half_s, kPlaceMagic), {zero, zero, zero});
  const V of_velocity = larger(larger(absolute(velocity.x), absolute(velocity.y)), absolute(velocity.z));
  const V of_spin = larger(larger(absolute(spin.x), absolute(spin.y)), absolute(spin.z));
  const V row[kGainDoubles] = {velocity.x, velocity.y, velocity.z, spin.x,     spin.y,
                               spin.z,     way_back.x, way_back.y, way_back.z, larger(of_velocity, of_spin)};
  double* const gains = work.gains + 2 * at * kGainDoubles;
  constexpr unsigned kFirst[] = {0, 4, 6};  // the last four overlap the four before
  for (const unsigned first : kFirst) scatter4(gains + first, 2 * kGainDoubles, row + first);
  alignas(64) double energy[kLanesHere], approach[kLanesHere], resting[kLanesHere];
  store(energy, body.mass * dot(velocity, velocity) + dot(hit.turn, turning));
  store(approach, hit.approach);
  store(resting, hit.resting ? V{} + 1.0 : zero);
  for (unsigned lane = 0; lane < kLanesHere; ++lane) {
    work.energy[2 * (at + lane)] = energy[lane];
    work.approach[(at + lane) * GroundCollisions::kEncounterDoubles] = approach[lane];
    work.resting[at + lane] = resting[lane] != 0 ? 1 : 0;
  }
}

template <int kWidth>
[[gnu::flatten]] void collide_ground(const GroundCollisions& work, std::size_t begin, std::size_t end) {
  for_rows<kWidth>({begin, end}, [&](auto v, std::size_t at) { collide_ground_at<decltype(v)>(work, at); });
}

template <int kWidth>
constexpr GroundKernels ground_kernels_of() {
  if constexpr (kWidth == 1) return {};
  return {find_ground_points<kWidth>, collide_ground<kWidth>};
}

}  // namespace
}  // namespace tumble::sim
