#pragma once

#include <algorithm>
#include <span>

#include "src/layered/find/free_path.h"
#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// The limit of manifolds. A manifold takes 2 kB, and n bodies in one place would make n² of them.
constexpr std::size_t manifolds_max(std::size_t bodies) { return 32768 + 16 * bodies; }

/// The number of pairs before those of a body.
inline std::size_t pairs_before(const PairTable& pairs, BodyIndex i) {
  return static_cast<std::size_t>(std::ranges::lower_bound(pairs.a, i) - pairs.a.begin());
}

/// Bodies that follow one another, and where their impulses begin in the state's memory.
struct BodyRange {
  BodyIndex first = 0, end = 0;
  MemoryPlace memory;
};

/// Appends the manifolds of some bodies, each with bodies of higher rows and with the ground, and lists fast pairs
/// (FastContacts). Stops early where `out` has more than manifolds_max. Adds manifolds and points to the hasher as
/// hash_manifolds would, which wants an empty `out`; null: does not.
void build_manifolds(const WorldState& state, const Scratch& scratch, double dt_s, const BodyRange& of,
                     ManifoldList& out, Hasher* hasher);

/// Some fast pairs, one or more, ascending.
struct FastRange {
  std::span<const ContactPair> pairs;
  std::span<const Approach> approaches;  ///< of these pairs in the substep
  const ContactMemory& memory;           ///< of the last substep, or of the last step
};

/// Appends the manifolds of fast pairs, from velocities and frames as they are. A pair that passes has no manifold.
void build_fast_manifolds(const WorldState& state, const Scratch& scratch, double substep_s, const FastRange& of,
                          ManifoldList& out);

}  // namespace tumble::sim
