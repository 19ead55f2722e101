#pragma once

#include <cstddef>
#include <memory>

#include "replay/format/step_record.h"
#include "src/base/result.h"
#include "src/model/scene.h"

/// Other people's engines behind one interface, so that they run the scenes that ours runs. Each is a program of its
/// own (peer_main.cc with one bullet_engine.cc, ode_engine.cc, …): `tumble` links none of them.
namespace tumble::peers {

/// What one body is; rows of read().
struct BodyState {
  sim::Vec3 position;
  sim::Quat orientation;
  sim::Vec3 velocity;
  sim::Vec3 spin;
  bool sleeping = false;
};

/// A world of one engine. SI units, z up, as the scenes have them; an engine that thinks otherwise converts.
class Engine {
 public:
  virtual ~Engine() = default;

  /// A new body. Errors (kBadInput): what the engine has no way to say.
  virtual Status add(const sim::BoxDef& box) = 0;

  /// Called once, after the bodies of the start and before the first step. Errors (kCannotFinish): no memory for it.
  virtual Status ready() { return {}; }

  /// One step. Errors (kCannotFinish): the engine gave up.
  virtual Status step(double dt_s) = 0;

  /// What the body added as number `row` (0, 1, …) is now.
  [[nodiscard]] virtual BodyState read(std::size_t row) const = 0;
};

/// The engine that this program was linked with.
replay::EngineName engine_name();

/// An empty world with the scene's gravity and ground. Engines with settings of their own keep their defaults, but for
/// what the scene says: friction is the geometric mean of a pair's, restitution the larger, wherever the engine can.
std::unique_ptr<Engine> make_engine(const sim::SceneDef& scene);

}  // namespace tumble::peers
