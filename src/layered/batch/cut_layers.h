#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Workers who share sweeps, at most: a bit each in SweepShares::users.
inline constexpr unsigned kSharesMost = 64;

/// Finds how many workers share the sweeps of so many layers and batches, and makes room for what they share. False:
/// one worker sweeps all.
bool start_shares(const WorldState& state, Scratch& scratch, std::size_t layers, std::size_t batches);

/// Gives each batch to the worker who solves it in every sweep of the step: a piece of each layer, cut across the axis
/// that the fewest contacts cross. What one of the workers who share the sweeps does, when it is known which manifolds
/// a batch has. All have met before, and meet afterwards.
void cut_layers(const WorldState& state, Scratch& scratch, const Worker& worker);

/// Calls visit(begin, end) for the runs of numbers that follow one another.
template <class Visit>
void for_runs(std::span<const std::uint32_t> numbers, Visit visit) {
  for (std::size_t k = 0; k < numbers.size();) {
    const std::uint32_t begin = numbers[k];
    for (++k; k < numbers.size() && numbers[k] == numbers[k - 1] + 1; ++k) continue;
    visit(begin, numbers[k - 1] + 1);
  }
}

/// Calls visit(begin, end) for ranges of the batches that one of these workers solves in sweeps.
template <class Visit>
void for_own_batches(const Scratch& scratch, const Worker& worker, Visit visit) {
  const std::size_t layers = scratch.contact_batches.layer_start.size() - 1;
  for (std::size_t layer = 0; layer < layers; ++layer) {
    for_runs(scratch.shares.batches_of(layer, worker.part), visit);
  }
}

}  // namespace tumble::sim
