#include <algorithm>

#include "src/step/step.h"

namespace tumble::sim {

void PhaseHashes::phase_done(std::uint32_t substep, std::size_t phase, const World& world) {
  const std::span<const Phase> phases = phase_table(world.state().def.method).phases;
  const std::size_t at = std::min(substep, kRowsMax - 1) * phases.size() + phase;
  hasher_.reset();
  if (at < words_.size()) hasher_.add(words_[at]);  // the last row: fold into what is there
  phases[phase].hash(world, hasher_);
  const std::uint64_t word = hasher_.digest().low;
  if (at < words_.size()) {
    words_[at] = word;
  } else {
    words_.push_back(word);
  }
}

}  // namespace tumble::sim
