#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tumble/replay/session.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"
#include "tumble/sim/step.h"
#include "tumble/sim/world_state.h"

namespace tumble::hunt {

/// The id that stands for the ground in a Meeting; no body has it.
inline constexpr sim::BodyId kGroundId = 0;

/// Two bodies, the lower id first, or the ground and a body.
using Meeting = std::pair<sim::BodyId, sim::BodyId>;

/// The force of one contact of method thesis in one substep, as impulses.
struct ContactForce {
  sim::BodyId a = kGroundId, b = kGroundId;
  double normal = 0;   ///< N·s, >= 0 where the contact pushes
  double tangent = 0;  ///< N·s, the magnitude across the normal
  double depth = 0;    ///< m, of the overlap that was parted
};

/// A step as this build took it.
struct TracedStep {
  double dt = 0;                     ///< s
  std::vector<sim::Command> inputs;  ///< before the step
  sim::StepCounters counters;
  std::vector<std::uint64_t> words;  ///< sim::PhaseHashes
  std::vector<Meeting> met;          ///< ascending, each once: pairs for which the engine solved a contact, with or
                                     ///< without force, in any substep
  std::vector<ContactForce> forces;
  // Method layered: what happened in the step.
  bool fast_pairs = false, hard_islands = false, lent_inertia = false, parted = false;
  std::optional<sim::WorldState> begun = std::nullopt;  ///< the state before with the inputs applied; none: no inputs
};

struct EngineFiles;  // golden/hunt/engine/kept_run.h

/// A session of a scene with everything that relations and laws look at.
struct Trace {
  sim::SceneDef scene;
  std::vector<sim::WorldState> states;  ///< states[k] is state k; at least state 0
  std::vector<TracedStep> steps;        ///< steps[k] led from states[k] to states[k + 1]
  std::string failure;                  ///< of the step after the last; empty: the session ran to its end
  /// The session of another scene, computed by what computed this one. Errors: the scene is none.
  std::function<Result<Trace>(const sim::SceneDef& scene)> again;
  bool external = false;  ///< another engine's, of which states and inputs are known, and no hashes and no contacts;
                          ///< `met` are then the pairs that may have met
  std::shared_ptr<const EngineFiles> ran;  ///< what an engine left of its run; null: this program's session
  /// The state from which an engine's session has other bodies than its scene, as `failure` says. The trace ends
  /// before.
  std::optional<std::uint64_t> other_bodies = std::nullopt;
  double fall = 1;      ///< how far a body at rest falls in a step, in ½ g dt²: 1 on a parabola; of an engine, by its
                        ///< integrator
  double rounding = 0;  ///< of a number, relative, that laws allow besides their own bounds: of engines with floats

  [[nodiscard]] const sim::WorldState& after(std::size_t step) const { return states[step + 1]; }
  [[nodiscard]] const sim::WorldState& before(std::size_t step) const { return states[step]; }
  /// The state that the step itself began with, inputs included.
  [[nodiscard]] const sim::WorldState& begun(std::size_t step) const {
    return steps[step].begun ? *steps[step].begun : states[step];
  }
};

/// Runs a scene. Errors: state 0 cannot be made, or an input is refused: the scene is none.
Result<Trace> trace(const sim::SceneDef& scene);

}  // namespace tumble::hunt
