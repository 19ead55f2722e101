#include "replay/live/phase_times.h"

namespace tumble::replay {

void PhaseTimes::begin(sim::Method method, sim::Observer* inner) {
  inner_ = inner;
  names_.clear();
  for (const sim::Phase& phase : sim::phase_table(method).phases) names_.push_back(phase.name);
  seconds_.assign(names_.size(), 0);
  inner_seconds_ = 0;
  last_ = Clock::now();
}

void PhaseTimes::phase_done(std::uint32_t substep, std::size_t phase, const sim::World& world) {
  const Clock::time_point done = Clock::now();
  seconds_[phase] += std::chrono::duration<double>(done - last_).count();
  if (inner_ != nullptr) inner_->phase_done(substep, phase, world);
  last_ = Clock::now();
  inner_seconds_ += std::chrono::duration<double>(last_ - done).count();
}

}  // namespace tumble::replay
