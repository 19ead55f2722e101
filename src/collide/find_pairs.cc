#include "src/collide/find_pairs.h"

#include "src/collide/sweep.h"

namespace tumble::sim {

Status find_pairs(World& world, double /*dt_s*/) {
  update_frames(world.bodies(), world.mutable_scratch());
  find_overlaps(world.mutable_scratch(), world.mutable_state().pairs);
  world.mutable_scratch().old_planes = world.state().pairs.planes;
  return check_crowd(world.scratch());
}

// The pairs' own planes are find_planes's by the time that trial phases are hashed.
void hash_find_pairs(const World& world, Hasher& hasher) {
  const Scratch& scratch = world.scratch();
  const PairTable& pairs = world.state().pairs;
  hasher.add(std::span<const BodyIndex>(pairs.a));
  hasher.add(std::span<const BodyIndex>(pairs.b));
  hasher.add(std::span<const std::uint16_t>(scratch.old_planes));
  hasher.add(std::span<const double>(scratch.aabb_low.z));
  hash_frames(scratch, hasher);
}

}  // namespace tumble::sim
