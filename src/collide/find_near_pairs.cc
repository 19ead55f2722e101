#include "src/collide/find_near_pairs.h"

#include "src/collide/strips.h"
#include "src/collide/sweep.h"
#include "src/math/grid.h"
#include "src/world/body_kernels.h"

namespace tumble::sim {
namespace {

constexpr std::size_t kWorthBodies = 32768;  // for a thread more

// Widens a body's AABB to where it may come within the step.
void reach_out(const Bodies& bodies, Scratch& scratch, BodyIndex i, double fall, double dt_s) {
  scratch.turning[i] = turning_reach(bodies, i, dt_s);
  const double around = kContactSlack + fall + scratch.turning[i];
  const Vec3 margin = Vec3::Constant(PositionGrid::round(around) + PositionGrid::kStep);
  const Vec3 path = PositionGrid::round(Vec3(bodies.velocity[i] * dt_s));
  scratch.aabb_low.set(i, scratch.aabb_low[i] - margin + path.cwiseMin(Vec3::Zero()));
  scratch.aabb_high.set(i, scratch.aabb_high[i] + margin + path.cwiseMax(Vec3::Zero()));
}

// Returns where it stopped.
std::size_t reach_out_in_lanes(const Bodies& bodies, Scratch& scratch, std::size_t begin, std::size_t end, double fall,
                               double dt_s) {
  const BodyKernels* lanes = body_kernels(scratch.lanes);
  if (lanes == nullptr) return begin;
  const Vec3Column &v = bodies.velocity, &w = bodies.spin, &half = bodies.half_extent;
  Vec3Column &low = scratch.aabb_low, &high = scratch.aabb_high;
  return lanes->reach_out({begin,
                           end,
                           {v.x.data(), v.y.data(), v.z.data()},
                           {w.x.data(), w.y.data(), w.z.data()},
                           {half.x.data(), half.y.data(), half.z.data()},
                           kContactSlack + fall,
                           dt_s,
                           scratch.turning.data(),
                           {low.x.data(), low.y.data(), low.z.data()},
                           {high.x.data(), high.y.data(), high.z.data()}});
}

}  // namespace

double turning_reach(const Bodies& bodies, BodyIndex i, double dt_s) {
  return length(bodies.spin[i]) * length(bodies.half_extent[i]) * dt_s;
}

double falling_reach(const WorldDef& def, double dt_s) { return length(def.gravity) * dt_s * dt_s; }

Status find_near_pairs(World& world, double dt_s) {
  const Bodies& bodies = world.bodies();
  Scratch& scratch = world.mutable_scratch();
  update_frames(bodies, scratch);
  const double fall = falling_reach(world.state().def, dt_s);
  scratch.turning.resize(bodies.size());
  for_ranges(scratch.workers, bodies.size(), kWorthBodies, [&](std::size_t begin, std::size_t end) {
    std::size_t i = reach_out_in_lanes(bodies, scratch, begin, end, fall, dt_s);
    for (; i < end; ++i) reach_out(bodies, scratch, static_cast<BodyIndex>(i), fall, dt_s);
  });
  find_overlaps_in_strips(scratch, world.mutable_state().pairs);
  return check_crowd(scratch);
}

void hash_find_near_pairs(const World& world, Hasher& hasher) {
  const PairTable& pairs = world.state().pairs;
  hasher.add(std::span<const BodyIndex>(pairs.a));
  hasher.add(std::span<const BodyIndex>(pairs.b));
  hasher.add(std::span<const std::uint16_t>(pairs.planes));
  hasher.add(std::span<const double>(world.scratch().turning));
  hash_frames(world.scratch(), hasher);
}

}  // namespace tumble::sim
