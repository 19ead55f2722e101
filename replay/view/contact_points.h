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

/// Contact points of any step of a log that this build can step. No log of ours holds them: they are computed by
/// stepping from the nearest keyframe, or on from the step asked for before.
class ContactSource {
 public:
  /// `log` must outlive this object; others may read from it between two calls.
  explicit ContactSource(LogReader& log) : log_(&log) {}

  /// Of step k of first_state() + 1 … last_step(); none for first_state(). Errors: Player::at's and Player::step's.
  Result<std::vector<ContactPoint>> read(std::uint64_t k);

 private:
  LogReader* log_;
  std::optional<Player> player_;
};

}  // namespace tumble::replay
