#pragma once

#include <cstdint>
#include <span>

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// How often contacts are swept. Each island has numbers of its own (find_islands.h).

/// The most sweeps that push_contacts and relax_contacts give an island of at most so many layers.
int most_sweeps(std::uint32_t layers, bool hard);

/// The most turns of a bounce (bounce_layers).
inline constexpr int kBounceTurnsMax = 32;

/// Sweeps of part_overlaps beyond those, for the deepest overlap, m: boxes that lie deep in each other from the start
/// jam if few sweeps part them.
int parting_sweeps(double deepest);

/// Counts the sweeps of each body's contacts, and their turns in bounces, when these have layers. in_hard:
/// find_hard_islands. Needs find_hits.
void count_sweeps(const WorldState& state, Scratch& scratch, std::span<const std::uint8_t> in_hard);

/// Counts the sweeps of part_overlaps for contacts whose island has overlaps of more than one sweep's worth. The
/// contacts that overlap are marked (find_overlaps).
void count_parting_sweeps(const WorldState& state, Scratch& scratch);

}  // namespace tumble::sim
