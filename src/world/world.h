#pragma once

#include <memory>

#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble {
class Workers;
}

namespace tumble::sim {

struct Scratch;

/// A running simulation: the state, and the memory that the phases of a step pass on to each other. tumble/sim/step.h
/// has the functions that make one (create_world), change one between steps (apply) and move one (step). A copy is
/// independent of the original; a world that was moved from can only be assigned to or destroyed. After an error of
/// step() the world must not be used on; an input that apply() refuses changes nothing.
class World {
 public:
  /// A world that continues from a snapshot. Errors: inconsistent columns, the floating-point environment.
  static Result<World> restore(WorldState state);

  World(const World& other);
  World(World&& other) noexcept;
  World& operator=(const World& other);
  World& operator=(World&& other) noexcept;
  ~World();

  [[nodiscard]] const WorldState& state() const { return state_; }
  [[nodiscard]] const Bodies& bodies() const { return state_.bodies; }
  /// The memory of the phases as the last one left it; src/world/scratch.h defines its fields.
  [[nodiscard]] const Scratch& scratch() const { return *scratch_; }

  /// Work done on the bodies by inputs since the last step, J (what each apply() added to the total energy).
  [[nodiscard]] double input_energy() const { return input_energy_; }

  /// Splits steps over these workers from now on; null: the calling thread does all. They must outlive their use, and
  /// show in nothing but time.
  void use(Workers* workers);

  // For src/step, imports of other engines' states, and tests.
  WorldState& mutable_state() { return state_; }
  Scratch& mutable_scratch() { return *scratch_; }
  void add_input_energy(double joules) { input_energy_ += joules; }
  void forget_input_energy() { input_energy_ = 0; }

 private:
  explicit World(WorldState state);

  WorldState state_;
  std::unique_ptr<Scratch> scratch_;  // never null but in a world that was moved from
  double input_energy_ = 0;
};

}  // namespace tumble::sim
