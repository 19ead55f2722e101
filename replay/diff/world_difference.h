#pragma once

#include <optional>

#include "tumble/replay/divergence.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/world_state.h"

namespace tumble::replay {

/// The parts of a complete state that are compared, besides parameters of the world and sizes, masses, inertias and
/// materials of bodies.
struct WorldParts {
  bool visible = true;  ///< the columns of the state hash
  bool hidden = true;   ///< rest times, near pairs, contacts remembered; another version of a method may keep others
};

/// The first property of a world, or of a body by ascending id, in which two complete states differ to the bit:
/// "world.gravity.z", "inertia.x", "low_energy_time", "contact_memory.impulse". Causes stand before effects. The phase
/// is "start".
std::optional<Divergence> world_difference(const sim::WorldState& expected, const sim::WorldState& actual,
                                           const WorldParts& parts = {});

/// Likewise for two complete states with their continuation hashes: hashes that differ although no property can be
/// named are a difference of the field "continuation_hash". The hashes count only where all parts are compared.
std::optional<Divergence> keyframe_difference(const sim::WorldState& expected, const Hash128& expected_hash,
                                              const sim::WorldState& actual, const Hash128& actual_hash,
                                              const WorldParts& parts = {});

}  // namespace tumble::replay
