#include <algorithm>

#include "tumble/sim/step.h"

namespace tumble::sim {

void PhaseHashes::phase_done(std::uint32_t substep, std::size_t phase, const World& world) {
  const std::span<const Phase> phases = phase_table(world.state().def.method).phases;
  const std::size_t row = std::min(substep, kRowsMax - 1);
  if (words_.size() <= row * phases.size()) words_.resize((row + 1) * phases.size(), 0);
  std::uint64_t& word = words_[row * phases.size() + phase];
  hasher_.reset();
  if (word != 0) hasher_.add(word);  // the last row: fold into what is there
  phases[phase].hash(world.state(), world.scratch(), hasher_);
  word = hasher_.digest().low;
}

}  // namespace tumble::sim
