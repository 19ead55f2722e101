#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "tumble/sim/step.h"

/// The scenes of `tumble bench threads` (docs/performance.md, Threads).
namespace tumble::bench {

using Clock = std::chrono::steady_clock;
inline double seconds_between(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double>(end - begin).count();
}

/// Warmed up in few and long steps, timed in those of docs/performance.md.
struct Trial {
  const char* name;
  const char* scene;
  std::vector<std::string> warm;
  double dt;  ///< s, of the steps that are timed
  std::uint32_t substeps;
};

const std::vector<Trial>& trials();

/// "6400, 25600, …"
std::string trial_names();

/// Ends the program with status 2.
[[noreturn]] void fail(const std::string& message);

void make_step(sim::World& world, sim::Observer* observer = nullptr);

/// The state from which timing starts.
sim::WorldState warm_state(const Trial& trial);

/// A world in that state.
sim::World world_from(const sim::WorldState& state);

}  // namespace tumble::bench
