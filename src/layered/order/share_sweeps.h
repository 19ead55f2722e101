#pragma once

#include <bit>
#include <cstdint>

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Gives each batch to the worker who solves it in every sweep of the step: a piece of each layer, cut across the axis
/// that the fewest contacts cross. A body of several workers' batches gets a row of its own for each of them (a copy
/// behind the ground's row), and the sides of the batches then name those. Written before the batches are prepared.
void share_sweeps(const WorldState& state, Scratch& scratch);

/// The row of a body for a worker who uses it.
inline std::uint32_t row_for(const SweepShares& shares, BodyIndex i, unsigned worker) {
  const std::uint64_t before = shares.users[i] & ((std::uint64_t{1} << worker) - 1);
  const auto rank = static_cast<std::uint32_t>(std::popcount(before));
  return rank == 0 ? i : shares.rows + shares.copies_before[i] + rank - 1;
}

/// Makes the copies in a range of a worker's equal to their bodies.
void renew_copies(Scratch& scratch, const Worker& worker);
/// Likewise, by several workers at a time.
void renew_copies(Scratch& scratch);

}  // namespace tumble::sim
