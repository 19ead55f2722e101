#include <algorithm>

#include "src/world/scratch.h"
#include "tumble/sim/step.h"

namespace tumble::sim {

Hasher* PhaseHashes::phase_begins() {
  hasher_.reset();
  return &hasher_;
}

void PhaseHashes::phase_done(std::uint32_t substep, std::size_t phase, const World& world) {
  const std::span<const Phase> phases = phase_table(world.state().def.method).phases;
  const std::size_t row = std::min(substep, kRowsMax - 1);
  if (words_.size() <= row * phases.size()) words_.resize((row + 1) * phases.size(), 0);
  std::uint64_t& word = words_[row * phases.size() + phase];
  if (world.scratch().fed_hasher != &hasher_) {
    hasher_.reset();
    phases[phase].hash(world.state(), world.scratch(), hasher_);
  }
  const std::uint64_t found = hasher_.digest().low;
  if (word != 0) {  // the last row: fold into what is there
    hasher_.reset();
    hasher_.add(word);
    hasher_.add(found);
    word = hasher_.digest().low;
  } else {
    word = found;
  }
}

}  // namespace tumble::sim
