#pragma once

#include <vector>

#include "src/base/result.h"
#include "src/model/scene.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// A running simulation: its state, and the scratch memory that the phases of a step pass on to each other. Move with
/// step() (src/step/step.h); change between steps only with apply(). After an error the world is not to be used on.
class World {
 public:
  /// The resolved start, state 0: positions and velocities rounded to their grids, frozen bodies given the bodies they
  /// touch as contact objects. Errors: limits.h exceeded, ids not ascending, a floating-point environment that does
  /// not round to nearest or flushes subnormals.
  /// Defined in src/step/create_world.cc.
  static Result<World> create(const SceneDef& scene);

  /// A world that continues from a snapshot. Errors: inconsistent columns, the floating-point environment.
  static Result<World> restore(WorldState state);

  /// Applies one input; defined in src/step/apply_command.cc. Errors: an unknown or taken id, a value out of limits;
  /// the world is then unchanged.
  Status apply(const Command& command);

  [[nodiscard]] const WorldState& state() const { return state_; }
  [[nodiscard]] const Bodies& bodies() const { return state_.bodies; }
  [[nodiscard]] const Scratch& scratch() const { return scratch_; }

  /// Work done on the bodies by inputs since the last step, J (what each apply() added to the total energy).
  [[nodiscard]] double input_energy() const { return input_energy_; }

  /// Steps are split over these hands from now on; null: none but the caller's. They must outlive their use, and show
  /// in nothing but time.
  void use(Workers* workers) { scratch_.workers = workers; }

  // For the phases only.
  WorldState& mutable_state() { return state_; }
  Scratch& mutable_scratch() { return scratch_; }
  void forget_input_energy() { input_energy_ = 0; }

 private:
  WorldState state_;
  Scratch scratch_;
  double input_energy_ = 0;
};

}  // namespace tumble::sim
