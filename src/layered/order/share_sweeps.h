#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "src/world/hash_on_the_way.h"
#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Gives each batch to the worker who solves it in every sweep of the step: a piece of each layer, cut across the axis
/// that the fewest contacts cross. A body of several workers' batches gets a row of its own for each of them (a copy
/// behind the ground's row), and the sides of the batches then name those. Written before the batches are prepared.
void share_sweeps(const WorldState& state, Scratch& scratch);

/// Calls visit(begin, end) for the runs of numbers that follow one another.
template <class Visit>
void for_runs(std::span<const std::uint32_t> numbers, Visit visit) {
  for (std::size_t k = 0; k < numbers.size();) {
    const std::uint32_t begin = numbers[k];
    for (++k; k < numbers.size() && numbers[k] == numbers[k - 1] + 1; ++k) continue;
    visit(begin, numbers[k - 1] + 1);
  }
}

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
  work_together(scratch.workers, shares.parts, [&](const Worker& worker) {
    for (std::size_t layer = 0; layer < scratch.contact_batches.touched_start.size(); ++layer) {
      for_runs(shares.batches_of(layer, worker.part), visit);
    }
  });
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
