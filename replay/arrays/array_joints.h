#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "replay/arrays/array_rows.h"
#include "replay/arrays/mujoco_model.h"
#include "tumble/sim/result.h"

/// The arrays qpos and qvel of MuJoCo.
namespace tumble::replay {

/// The free joints: number, and place in qpos.
std::vector<std::pair<std::size_t, std::size_t>> free_joints(const std::vector<MujocoJoint>& joints);

/// A warning where joints have no name, and get one; else empty.
std::string unnamed_joints(const std::vector<MujocoJoint>& joints);

/// The columns of both arrays, number by number, with the names of the joints. arrays: qpos and qvel, null where there
/// is none. poses: qpos also gives the positions and orientations of the bodies of free joints. The arrays outlive the
/// columns. Errors (kBadInput): another shape.
Result<std::vector<TableColumn>> joint_columns(const std::vector<MujocoJoint>& joints,
                                               const std::array<const Array*, 2>& arrays, std::size_t steps,
                                               bool poses);

}  // namespace tumble::replay
