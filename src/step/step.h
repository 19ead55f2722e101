#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/model/scene.h"
#include "src/world/world.h"

namespace tumble::sim {

/// One phase of a step: a name, the function that does it and the hash of what it wrote. The name is the same word in
/// this table, the phase's file, docs/step.md, the log and the tests.
struct Phase {
  const char* name;
  /// Advances the state by its part of a sub-step of dt_s. Errors name the phase and the body.
  Status (*run)(WorldState& state, Scratch& scratch, double dt_s);
  void (*hash)(const WorldState& state, const Scratch& scratch, Hasher& hasher);
};

/// The phases of a method, in the order they run: those before `substeps_begin` once a step, then those up to
/// `substeps_end` in every sub-step, then the rest once. `trial_count` first ones of a sub-step may be undone: the
/// sub-step is accepted, or halved and begun again, after them.
struct PhaseTable {
  std::span<const Phase> phases;
  std::size_t substeps_begin;
  std::size_t substeps_end;
  std::size_t trial_count;
};
PhaseTable phase_table(Method method);

/// What a step did, in numbers. Energies in J.
struct StepCounters {
  std::uint32_t pairs = 0;     ///< in the Active Collision List after the last sub-step
  std::uint32_t contacts = 0;  ///< thesis: collisions resolved, all sub-steps; layered: contact points solved
  std::uint32_t substeps = 0;  ///< accepted
  double kinetic = 0;          ///< after the step
  double potential = 0;        ///< after the step
  double inputs = 0;           ///< put in by the inputs before the step
  double removed = 0;          ///< taken out because separation had pumped it in
  friend bool operator==(const StepCounters&, const StepCounters&) = default;
};

/// Watches a step without the step knowing what for. Called after each phase of each accepted sub-step, in order (what
/// runs once a step counts to the first or the last sub-step); the world and its scratch still hold what the phase
/// wrote. References last for the call.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void phase_done(std::uint32_t substep, std::size_t phase, const World& world) = 0;
};

/// A world at the resolved start, state 0: positions and velocities rounded to their grids, frozen bodies given the
/// bodies they touch as contact objects. Errors: limits.h exceeded, ids not ascending, a floating-point environment
/// that does not round to nearest or flushes subnormals.
Result<World> create_world(const SceneDef& scene);

/// Applies one input between two steps. Errors: an unknown or taken id, a value out of limits; the world is then
/// unchanged.
Status apply(World& world, const Command& command);

/// Takes the world from state k to state k + 1 with its current dt.
Result<StepCounters> step(World& world, Observer* observer = nullptr);

/// Collects a step's phase hashes: one 64-bit word (the low half of XXH3-128) a phase and sub-step, sub-step by
/// sub-step; 0 where a phase did not run in that sub-step. Sub-steps from kRowsMax on are folded into the last row, so
/// a log stays small at any sub-step count.
class PhaseHashes : public Observer {
 public:
  static constexpr std::uint32_t kRowsMax = 16;
  /// Of what the phases' hashes cover and StepCounters count: raised whenever either changes while no state does, since
  /// words of two versions say nothing of each other. 1: some of what a phase wrote was left out, and method layered
  /// counted no contacts. 2: all that a phase writes and the future depends on. 3: the same, less some that
  /// a phase leaves as it was or only copies, in the order in which it lies in memory.
  static constexpr std::uint32_t kVersion = 3;

  void phase_done(std::uint32_t substep, std::size_t phase, const World& world) override;
  void clear() { words_.clear(); }

  /// rows × phases, row-major.
  [[nodiscard]] const std::vector<std::uint64_t>& words() const { return words_; }

 private:
  Hasher hasher_;
  std::vector<std::uint64_t> words_;
};

}  // namespace tumble::sim
