#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "tumble/sim/step.h"

namespace tumble::replay {

/// Measures the phases of steps by the clock on the wall: adds up the time of each phase over the substeps of a step.
/// Another observer's work, the hashing of what a phase wrote, is counted by itself.
class PhaseTimes : public sim::Observer {
 public:
  /// Begins a step of `method`. `inner` sees every phase too; it may be null.
  void begin(sim::Method method, sim::Observer* inner);
  void phase_done(std::uint32_t substep, std::size_t phase, const sim::World& world) override;

  [[nodiscard]] const std::vector<const char*>& names() const { return names_; }  ///< of the phases, in their order
  [[nodiscard]] const std::vector<double>& seconds() const { return seconds_; }   ///< of the last step, by phase
  [[nodiscard]] double inner_seconds() const { return inner_seconds_; }  ///< that the other observer took in it

 private:
  using Clock = std::chrono::steady_clock;
  sim::Observer* inner_ = nullptr;
  Clock::time_point last_;
  std::vector<const char*> names_;
  std::vector<double> seconds_;
  double inner_seconds_ = 0;
};

}  // namespace tumble::replay
