#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tumble/sim/result.h"

namespace tumble::replay {

/// A joint of a MuJoCo model, in the order of qpos.
struct MujocoJoint {
  enum class Kind { kFree, kBall, kSlide, kHinge };
  Kind kind = Kind::kHinge;
  std::string name;  ///< "joint 3" for the fourth joint where it has none
  bool unnamed = false;
  std::string body;  ///< of the body that it moves; empty without a name
  [[nodiscard]] std::size_t positions() const { return kind == Kind::kFree ? 7 : (kind == Kind::kBall ? 4 : 1); }
  [[nodiscard]] std::size_t velocities() const { return kind == Kind::kFree ? 6 : (kind == Kind::kBall ? 3 : 1); }
};

/// The joints of a model in MJCF, MuJoCo's XML (https://mujoco.readthedocs.io/en/stable/XMLreference.html), in document
/// order, which is that of qpos. A joint without a type has that of its default class. name: for messages. Errors
/// (kBadInput): no XML, no <worldbody>, an <include>.
Result<std::vector<MujocoJoint>> read_mujoco_joints(std::string_view xml, const std::string& name);

}  // namespace tumble::replay
