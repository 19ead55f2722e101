#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "replay/format/not_finite.h"
#include "tumble/replay/engine_log.h"
#include "tumble/replay/imported_table.h"
#include "tumble/sim/ids.h"

namespace tumble::replay {

/// Whether the states of a session fit what its engine says of it, whichever way they came: the direction and the size
/// of gravity, the unit and the sign of velocities and spins, dt, the order of quaternions. Nothing is refused for it.
class MotionCheck {
 public:
  /// What the engine gave; the rest was derived, and fits by itself.
  struct Told {
    bool velocity = true;
    bool spin = true;
  };
  /// m/s², from now on; in our axes.
  void set_gravity(const sim::Vec3& gravity) { gravity_ = gravity; }
  /// The state of a body, in our axes and units. axes: of the engine, for messages.
  void add(sim::BodyId body, std::uint64_t step, double dt, const EngineState& state, Told told,
           const EngineAxes& axes);
  /// Adds a warning, with its remedy, for each thing that most states contradict.
  void add_to(std::vector<std::string>& out) const;

 private:
  struct Before {
    std::uint64_t step = 0;
    double dt = 0;
    sim::Vec3 position = {0, 0, 0}, velocity = {0, 0, 0}, moved = {0, 0, 0};
    sim::Quat orientation;
    sim::Vec3 spin = {0, 0, 0};
  };
  /// How many states move as they say.
  struct Fit {
    std::uint64_t fitting = 0, off = 0, against = 0;
    double ratio = 0;  ///< of the first that is off
    void look(const sim::Vec3& moved, const sim::Vec3& told);
  };
  void look_at_fall(const sim::Vec3& change);
  void add_fall(std::vector<std::string>& out) const;
  [[nodiscard]] std::optional<std::size_t> down() const;

  std::map<sim::BodyId, Before> before_;
  EngineAxes axes_;
  sim::Vec3 gravity_ = {0, 0, 0};
  std::array<std::uint64_t, 6> falls_ = {};            // states that fall along −x, x, −y, y, −z, z
  std::array<std::map<int, std::uint64_t>, 6> sizes_;  // of their accelerations: 10·log10, rounded
  std::uint64_t at_rest_ = 0, scalar_last_ = 0;        // first orientations that are 1 0 0 0, and 0 0 0 1
  Fit velocities_, spins_;
  std::uint64_t turns_ = 0, degrees_ = 0;  // states that turn, and that turn as spins in degrees/s
};

/// Contacts that none can be: a number that is not finite, a normal that is no direction. Keeps the first, and counts.
class ContactCheck {
 public:
  void add(std::uint64_t step, const std::vector<EngineContact>& contacts);
  /// "step 3, contact of 1 and 2: depth is nan, and 4 more likewise"; empty without one.
  [[nodiscard]] std::string not_finite() const { return text_of(first_not_finite_, not_finite_); }
  /// "step 3, contact of 1 and 2: the normal has a length of 7, wanted 1".
  [[nodiscard]] std::string no_direction() const { return text_of(first_no_direction_, no_direction_); }

 private:
  static std::string text_of(const std::string& first, std::uint64_t count);
  std::string first_not_finite_, first_no_direction_;
  std::uint64_t not_finite_ = 0, no_direction_ = 0;
};

/// What is odd about a table that can still be imported. Of each kind of oddness the first place is kept, and a count.
class TableNotes {
 public:
  /// A body whose state is not finite, so that the body is lost. place: "t.csv:4:9: ".
  void lost(const std::string& place, const NotFinite& found);
  /// An orientation that is a rotation only roughly.
  void rough_rotation(const std::string& place, sim::BodyId body, std::uint64_t step, double length);
  /// A body that returns after steps without it.
  void came_back(const std::string& place, sim::BodyId body, std::uint64_t step);
  /// Bodies of the step before that the last step lacks.
  void short_end(const std::string& place, std::size_t bodies, std::size_t before, sim::BodyId first_missing);

  [[nodiscard]] std::vector<std::string> texts() const;

 private:
  std::set<sim::BodyId> lost_;
  NotFinite first_lost_;
  std::string place_of_lost_;
  std::uint64_t rough_ = 0;
  std::string first_rough_;
  std::string short_end_;
  std::uint64_t back_ = 0;
  std::string first_back_;
};

}  // namespace tumble::replay
