#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "src/layered/batch/cut_layers.h"
#include "src/world/hash_on_the_way.h"
#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Gives a body of several workers' batches a row of its own for each of them (a copy behind the ground's row); the
/// sides of the batches then name those. Finds homes of bodies anew where many have moved (Homes). Written
/// before the batches are prepared.
void share_sweeps(const WorldState& state, Scratch& scratch);

/// The row of a body for a worker who uses it.
inline std::uint32_t row_for(const SweepShares& shares, BodyIndex i, unsigned worker) {
  const std::uint64_t before = shares.users[i] & ((std::uint64_t{1} << worker) - 1);
  const auto rank = static_cast<std::uint32_t>(std::popcount(before));
  return rank == 0 ? i : shares.rows + shares.copies_before[i] + rank - 1;
}

/// Calls visit(begin, end) for ranges of batches that make up all: each worker gets those that it solves in sweeps, so
/// that their lines stay with its processor.
template <class Visit>
void for_shared_batches(Scratch& scratch, Visit visit) {
  const SweepShares& shares = scratch.shares;
  if (shares.parts == 1) {
    return for_ranges(scratch.workers, scratch.contact_batches.batches.size(), kBatchesAPart, visit);
  }
  work_together(scratch.workers, shares.parts, [&](const Worker& worker) { for_own_batches(scratch, worker, visit); });
}
/// Likewise; with a hasher one block after the other, each followed by hash(begin, end).
template <class Visit, class Hash>
void for_hashed_batches(Hasher* hasher, Scratch& scratch, Visit visit, Hash hash) {
  if (hasher == nullptr) return for_shared_batches(scratch, visit);
  for_hashed_ranges(hasher, nullptr, scratch.contact_batches.batches.size(), kBatchesAPart, kBatchesABlock, visit,
                    hash);
}

/// Makes the copies in a range of a worker's equal to their bodies.
void renew_copies(Scratch& scratch, const Worker& worker);
/// Likewise, by several workers at a time.
void renew_copies(Scratch& scratch);

}  // namespace tumble::sim
