#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tumble/replay/log_reader.h"
#include "tumble/replay/player.h"
#include "tumble/sim/result.h"
#include "tumble/sim/vec.h"

namespace tumble::replay {

/// One contact point of the last substep of a step.
struct ContactPoint {
  sim::BodyId a = 0;             ///< the lower id
  std::optional<sim::BodyId> b;  ///< none: the ground
  sim::Vec3 at = {0, 0, 0};      ///< m, world
  sim::Vec3 normal = {0, 0, 0};  ///< from a to b; of the ground: up
  double depth = 0;              ///< m; negative: about to touch
  double impulse = 0;            ///< N·s along the normal
};

/// The contact points that the world's last step left.
std::vector<ContactPoint> contact_points(const sim::World& world);

/// Contact points of any step of a log. Another engine's log may hold them. No log of ours does: they are computed by
/// stepping from the nearest keyframe, or on from the step asked for before.
class ContactSource {
 public:
  /// `log` must outlive this object; others may read from it between two calls.
  explicit ContactSource(LogReader& log) : log_(&log) {}

  /// Of step k of first_state() … last_step(); none for the first state of ours. Errors: the log's; kBadInput: another
  /// engine's log without contacts of this step; Player::at's and Player::step's; kCannotFinish where this build
  /// computes another state than the log holds.
  Result<std::vector<ContactPoint>> read(std::uint64_t k);

 private:
  Result<std::vector<ContactPoint>> logged(std::uint64_t k);

  LogReader* log_;
  std::optional<Player> player_;
};

}  // namespace tumble::replay
