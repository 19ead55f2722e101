#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tumble/replay/engine_log.h"
#include "tumble/replay/imported_table.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/rotation.h"

namespace tumble::replay {

/// Whether the states of a session fit what its engine says of it, whichever way they came: the direction and the size
/// of gravity, the unit and the sign of velocities and spins, dt, the order of quaternions; and whether bodies leap.
/// Nothing is refused for it.
class MotionCheck {
 public:
  /// What the engine gave; the rest was derived, and fits by itself.
  struct Told {
    bool velocity = true;
    bool spin = true;
    bool quaternion = true;  ///< else the orientation was made of angles
  };
  /// m/s², from now on; in our axes.
  void set_gravity(const sim::Vec3& gravity) { gravity_ = gravity; }
  /// Quaternions were read as x y z w because somebody asked for it; else as w x y z.
  void set_scalar_last(bool asked) { scalar_last_asked_ = asked; }
  /// The state of a body, in our axes and units. edge: the body's longest, m. axes: of the engine, for messages.
  void add(sim::BodyId body, std::uint64_t step, double dt, const EngineState& state, Told told, double edge,
           const EngineAxes& axes);
  /// The name of a body; empty without one.
  using NameOf = std::function<std::string(sim::BodyId)>;
  /// Adds a warning, with its remedy, for each thing that most states contradict, and for leaps.
  void add_to(std::vector<std::string>& out, const NameOf& name_of = {}) const;

 private:
  static constexpr std::uint64_t kStatesMin = 8;  // that say something of a session
  static constexpr double kBeside = 0.02;         // of an acceleration along one axis: what may be beside it

  struct Before {
    std::uint64_t step = 0;
    double dt = 0;
    sim::Vec3 position = {0, 0, 0}, velocity = {0, 0, 0}, moved = {0, 0, 0};
    sim::Quat orientation;
    sim::Vec3 spin = {0, 0, 0};
    /// m, moved in this step and in those before it.
    std::optional<double> way, way_before, way_long_before;
    sim::Vec3 moved_before = {0, 0, 0};
    std::optional<sim::Vec3> change;  ///< m/s², of the velocity
  };
  /// How many states move as they say.
  struct Fit {
    std::uint64_t fitting = 0, off = 0, against = 0;
    std::uint64_t aside = 0;  ///< off, in the direction alone
    double ratio = 0;         ///< of the first that is off in size
    void look(const sim::Vec3& moved, const sim::Vec3& told);
    [[nodiscard]] std::uint64_t all() const { return fitting + off + against; }
    [[nodiscard]] bool mostly_fits() const;
  };
  /// A body that moves much farther in one step than in the steps beside it.
  struct Leap {
    sim::BodyId body = 0;
    std::uint64_t step = 0;
    double way = 0, beside = 0;  ///< m
    bool is_back = false;        ///< the next step undoes it
  };
  void look_at_order(const sim::Quat& q, bool is_first);
  [[nodiscard]] sim::Quat in_other_order(const sim::Quat& ours) const;
  void look_at_fall(const sim::Vec3& change, const sim::Vec3& before, const sim::Vec3& moved);
  void look_at_turn(const Before& before, const EngineState& state, double dt, bool is_quaternion);
  void look_at_leap(sim::BodyId body, const Before& before, double way, double edge);
  void look_at_leap_and_back(sim::BodyId body, const Before& before, double way, double edge);
  [[nodiscard]] std::string leap_text(const NameOf& name_of) const;
  [[nodiscard]] std::string wrong_order() const;
  void add_fall(std::vector<std::string>& out) const;
  void add_upright(std::vector<std::string>& out) const;
  [[nodiscard]] std::optional<std::size_t> down() const;

  std::map<sim::BodyId, Before> before_;
  EngineAxes axes_;
  sim::Vec3 gravity_ = {0, 0, 0}, start_gravity_ = {0, 0, 0};
  bool scalar_last_asked_ = false;
  std::array<std::uint64_t, 6> falls_ = {};            // states that fall along −x, x, −y, y, −z, z
  std::array<std::map<int, std::uint64_t>, 6> sizes_;  // of their accelerations: 10·log10, rounded
  std::uint64_t at_rest_ = 0, scalar_last_ = 0;        // first orientations not turned as read, and in the other order
  std::uint64_t states_ = 0, half_turns_ = 0;          // all, and those that read as half turns about a slanting axis
  Fit velocities_, spins_;
  Fit order_, other_order_;  // of turns by spins, in the order of the quaternion as read, and in the other
  std::uint64_t turns_ = 0, degrees_ = 0;  // states that turn, and that turn as spins in degrees/s
  Leap leap_;                              // the first
  std::uint64_t leaps_ = 0;
};

}  // namespace tumble::replay
