#pragma once

#include <cstddef>
#include <memory>

#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

/// Other engines behind one interface, so that they run our scenes. Each is a program of its
/// own (peer_main.cc with one bullet_engine.cc, ode_engine.cc, …): `tumble` links none of them.
namespace tumble::peers {

/// One body; a row of read().
struct BodyState {
  sim::Vec3 position;
  sim::Quat orientation;
  sim::Vec3 velocity;
  sim::Vec3 spin;
  bool sleeping = false;
};

/// A world of one engine. SI units, z up, as in scenes; an engine with other conventions converts.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Adds a body. Errors (kBadInput): a property that the engine lacks.
  virtual Status add(const sim::BoxDef& box) = 0;

  /// Called once, after the bodies of the start and before the first step. Errors (kCannotFinish): no memory for it.
  virtual Status ready() { return {}; }

  /// Gravity from the next step on, m/s²; wakes every body.
  virtual Status set_gravity(const sim::Vec3& gravity) = 0;

  /// One step. Errors (kCannotFinish): the engine gave up.
  virtual Status step(double dt_s) = 0;

  /// The present state of the body added as number `row` (0, 1, …).
  [[nodiscard]] virtual BodyState read(std::size_t row) const = 0;
};

/// The engine that this program was linked with.
replay::EngineName engine_name();

/// An empty world with the scene's gravity and ground. Engines keep the defaults of their own settings, except for
/// properties of the scene: friction is the geometric mean of a pair's, restitution the larger, wherever the engine
/// can.
std::unique_ptr<Engine> make_engine(const sim::SceneDef& scene);

}  // namespace tumble::peers
