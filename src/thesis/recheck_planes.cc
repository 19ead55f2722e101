#include "src/thesis/recheck_planes.h"

#include "src/collide/box_pair.h"

namespace tumble::sim {

Status recheck_planes(WorldState& state, Scratch& scratch, double /*dt_s*/) {
  const Bodies& bodies = state.bodies;
  PairTable& pairs = state.pairs;
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (scratch.touched[i] != 0) scratch.frames[i].position = bodies.position[i];
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const BodyIndex a = pairs.a[k], b = pairs.b[k];
    const bool displaced = scratch.touched[a] != 0 || scratch.touched[b] != 0;
    if (pairs.planes[k] == 0 || !displaced) continue;
    pairs.planes[k] = separating(scratch.frames[a], scratch.frames[b], pairs.planes[k]);
  }
  return {};
}

void hash_recheck_planes(const WorldState& state, const Scratch& /*scratch*/, Hasher& hasher) {
  hasher.add(std::span<const std::uint16_t>(state.pairs.planes));
}

}  // namespace tumble::sim
