#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"
#include "tumble/sim/world.h"

namespace tumble::sim {

/// One phase of a step: a name, the function, and the hash of everything that the function wrote. One name serves this
/// table, the phase's file, docs/step.md, the log and the tests.
struct Phase {
  const char* name;
  /// Advances the state by its part of a substep of dt_s. Errors name the phase and the body.
  Status (*run)(WorldState& state, Scratch& scratch, double dt_s);
  void (*hash)(const WorldState& state, const Scratch& scratch, Hasher& hasher);
};

/// The phases of a method in their order: those before `substeps_begin` run once a step, those up to `substeps_end` in
/// every substep, the rest once a step. The first `trial_count` phases of a substep are a trial: after them the substep
/// is accepted, or undone and taken again in two halves.
struct PhaseTable {
  std::span<const Phase> phases;
  std::size_t substeps_begin;
  std::size_t substeps_end;
  std::size_t trial_count;
};
PhaseTable phase_table(Method method);

/// Counts and energies of a step. Energies in J.
struct StepCounters {
  std::uint32_t pairs = 0;     ///< in the Active Collision List after the last substep
  std::uint32_t contacts = 0;  ///< thesis: collisions resolved, all substeps; layered: contact points solved
  std::uint32_t substeps = 0;  ///< accepted
  double kinetic = 0;          ///< after the step
  double potential = 0;        ///< after the step
  double inputs = 0;           ///< put in by the inputs before the step
  double removed = 0;          ///< dissipated, because separation had added it
  friend bool operator==(const StepCounters&, const StepCounters&) = default;
};

/// Observes a step; the step knows nothing of the purpose. phase_done() is called after each phase of each accepted
/// substep, in order; a phase that runs once a step counts to the first or the last substep. World and scratch still
/// hold the values that the phase wrote. References last for the call.
class Observer {
 public:
  virtual ~Observer() = default;
  /// Called before a phase that is not tried. A hasher, empty: the phase may feed it, while it writes, what its hash
  /// function would add; if it has, Scratch::fed_hasher is that hasher when phase_done() is called.
  virtual Hasher* phase_begins() { return nullptr; }
  virtual void phase_done(std::uint32_t substep, std::size_t phase, const World& world) = 0;
};

/// A world at the resolved start, state 0, on its grids, frozen bodies given the bodies they touch as contact objects.
/// scene.inputs are left to the caller, who applies each before its step, as replay::Session does. Errors: limits.h
/// exceeded, ids not ascending, a floating-point environment that does not round to nearest or flushes subnormals.
Result<World> create_world(const SceneDef& scene);

/// Applies one input between two steps. Errors: an unknown or taken id, a value out of limits; the world is then
/// unchanged.
Status apply(World& world, const Command& command);

/// Takes the world from state k to state k + 1 with its current dt. Errors: kCannotFinish with step and phase when a
/// body leaves the limits or too many bodies crowd; the world must not be used on. `observer` may be null.
Result<StepCounters> step(World& world, Observer* observer = nullptr);

/// Collects a step's phase hashes: one 64-bit word (the low half of XXH3-128) for each phase and substep, substep by
/// substep; 0 where a phase did not run in that substep. Substeps from kRowsMax on are folded into the last row, so
/// that a log stays small at any number of substeps.
class PhaseHashes : public Observer {
 public:
  static constexpr std::uint32_t kRowsMax = 16;
  /// The version of the phase hashes' coverage and of StepCounters; raised when either changes while no state does,
  /// since words of different versions cannot be compared. docs/log_format.md says what each version covers.
  static constexpr std::uint32_t kVersion = 9;

  Hasher* phase_begins() override;
  void phase_done(std::uint32_t substep, std::size_t phase, const World& world) override;
  void clear() { words_.clear(); }

  /// rows × phases, row-major.
  [[nodiscard]] const std::vector<std::uint64_t>& words() const { return words_; }

 private:
  Hasher hasher_;
  std::vector<std::uint64_t> words_;
};

}  // namespace tumble::sim
