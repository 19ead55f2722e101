#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "replay/format/not_finite.h"
#include "tumble/replay/engine_log.h"
#include "tumble/replay/imported_table.h"
#include "tumble/sim/ids.h"

namespace tumble::replay {

/// What is odd about a table that can still be imported. Of each kind of oddness the first place is kept, and a count.
class TableNotes {
 public:
  /// A body whose state is not finite, so that the body is lost. place: "t.csv:4:9: ".
  void lost(const std::string& place, const NotFinite& found);
  /// An orientation that is a rotation only roughly.
  void rough_rotation(const std::string& place, sim::BodyId body, std::uint64_t step, double length);
  /// A body that returns after steps without it.
  void came_back(const std::string& place, sim::BodyId body, std::uint64_t step);
  /// The state of a body, in our axes and units: looked at for the direction and size of gravity, for the order of
  /// quaternions, and for velocities that do not fit the positions.
  void motion(sim::BodyId body, std::uint64_t step, double dt, const EngineState& state, bool has_velocity,
              const EngineAxes& axes);
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

  void add_motion(std::vector<std::string>& out) const;
  struct Before {
    std::uint64_t step = 0;
    double dt = 0;
    sim::Vec3 position = {0, 0, 0}, velocity = {0, 0, 0}, moved = {0, 0, 0};
  };
  std::map<sim::BodyId, Before> before_;
  EngineAxes axes_;
  std::array<std::uint64_t, 6> falls_ = {};         // rows that fall along −x, x, −y, y, −z, z
  std::map<int, std::uint64_t> sizes_;              // of their accelerations: 10·log10, rounded
  std::uint64_t at_rest_ = 0, scalar_last_ = 0;     // first orientations that are 1 0 0 0, and 0 0 0 1
  std::uint64_t far_ = 0, near_ = 0, fitting_ = 0;  // steps of bodies that moved farther or less than velocities say
  double ratio_ = 0;                                // of the first that did not fit
};

}  // namespace tumble::replay
