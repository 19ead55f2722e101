#include "src/layered/find/find_near_pairs.h"

#include "src/collide/strips.h"
#include "src/collide/sweep.h"
#include "src/kernels/kernels_by_width.h"
#include "src/layered/find/velocity_ranges.h"
#include "src/world/body_columns.h"
#include "src/world/for_bodies.h"
#include "src/world/hash_on_the_way.h"

namespace tumble::sim {
namespace {

void add_pairs(const WorldState& state, const Scratch& scratch, Hasher& hasher) {
  const PairTable& pairs = state.pairs;
  hasher.add(std::span<const BodyIndex>(pairs.a));
  hasher.add(std::span<const BodyIndex>(pairs.b));
  hasher.add(std::span<const std::uint16_t>(pairs.planes));
  hasher.add(std::span<const double>(scratch.turning));
  hash_velocity_ranges(scratch, hasher);
}

}  // namespace

double falling_reach(const WorldDef& def, double dt_s) { return length(def.gravity) * dt_s * dt_s; }

Status find_near_pairs(WorldState& state, Scratch& scratch, double dt_s) {
  const std::size_t n = state.bodies.size();
  Hasher* const hasher = take_hasher(scratch);
  update_frames(state.bodies, scratch, hasher);
  scratch.turning.resize(n);
  const BodyColumns bodies = columns_of(state.bodies);
  ReachColumns reach = {kContactSlack + falling_reach(state.def, dt_s), dt_s, scratch.turning.data(), {}, {}};
  put_pointers(scratch.aabb_low, reach.low);
  put_pointers(scratch.aabb_high, reach.high);
  for_bodies(scratch, n, [&](std::size_t begin, std::size_t end) {
    kernels(scratch.lanes).bodies.expand_aabbs(bodies, {begin, end}, reach);
  });
  find_overlaps_in_strips(scratch, state.pairs);
  if (find_velocity_ranges(state, scratch, dt_s)) {
    widen_aabbs(state, scratch, dt_s);
    find_overlaps_in_strips(scratch, state.pairs);
  }
  if (hasher != nullptr) add_pairs(state, scratch, *hasher);
  return check_crowd(scratch);
}

void hash_find_near_pairs(const WorldState& state, const Scratch& scratch, Hasher& hasher) {
  hash_frames(scratch, hasher);
  add_pairs(state, scratch, hasher);
}

}  // namespace tumble::sim
