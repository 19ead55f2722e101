#include "src/collide/find_pairs.h"

#include "src/collide/sweep.h"

namespace tumble::sim {

Status find_pairs(World& world, double /*dt_s*/) {
  update_frames(world.bodies(), world.mutable_scratch());
  find_overlaps(world.mutable_scratch(), world.mutable_state().pairs);
  return {};
}

void hash_find_pairs(const World& world, Hasher& hasher) {
  const PairTable& pairs = world.state().pairs;
  hasher.add(std::span<const BodyIndex>(pairs.a));
  hasher.add(std::span<const BodyIndex>(pairs.b));
}

}  // namespace tumble::sim
