#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"
#include "tumble/sim/step.h"
#include "tumble/sim/world.h"

namespace tumble::sim {
enum class LaneWidth : std::uint8_t;
}

namespace tumble::replay {

/// A step that a session took.
struct TakenStep {
  double dt = 0;                         ///< s
  std::span<const sim::Command> inputs;  ///< applied before the step, in order; lasts until the session's next step
  sim::StepCounters counters;
};

/// A running session: a scene, its world, and the scene's input that comes next. Every program that steps a scene with
/// inputs uses this class, so all of them apply inputs at the same time and in the same order.
class Session {
 public:
  /// Begins with state 0 of the scene. Errors: create_world's.
  static Result<Session> start(sim::SceneDef scene);

  /// Resumes at `state`. scene.inputs holds the inputs still to come; without a scene the caller passes all inputs to
  /// step(). Errors: World::restore's.
  static Result<Session> resume(sim::WorldState state, sim::SceneDef scene = {});

  /// Applies the scene's inputs that are due before the next step, then `live`, each in order, and takes the step.
  /// Errors: an input that the world refuses (the message names input and step), sim::step's. After an error the
  /// session cannot step on.
  Result<TakenStep> step(std::span<const sim::Command> live = {}, sim::Observer* observer = nullptr);

  /// Sets the threads to step with; see World::use.
  void use(Workers* workers) { world_.use(workers); }

  /// Sets the width of the lanes to step with, which shows in nothing but time.
  void use(sim::LaneWidth lanes);

  [[nodiscard]] const sim::World& world() const { return world_; }
  [[nodiscard]] const sim::SceneDef& scene() const { return scene_; }
  /// The number of the state that the session is in: 0 at the start of a scene.
  [[nodiscard]] std::uint64_t steps_done() const { return world_.state().step; }

 private:
  Session(sim::SceneDef scene, sim::World world);
  Status apply_inputs(std::span<const sim::Command> live);

  sim::SceneDef scene_;
  sim::World world_;
  std::size_t next_input_ = 0;         // index in scene_.inputs
  std::vector<sim::Command> applied_;  // before the current step; a member to keep its memory
};

}  // namespace tumble::replay
