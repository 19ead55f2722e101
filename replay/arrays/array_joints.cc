#include "replay/arrays/array_joints.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "src/base/text.h"

namespace tumble::replay {

std::vector<std::pair<std::size_t, std::size_t>> free_joints(const std::vector<MujocoJoint>& joints) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  std::size_t at = 0;
  for (std::size_t j = 0; j < joints.size(); at += joints[j++].positions()) {
    if (joints[j].kind == MujocoJoint::Kind::kFree) found.emplace_back(j, at);
  }
  return found;
}

std::string unnamed_joints(const std::vector<MujocoJoint>& joints) {
  const auto first = std::ranges::find_if(joints, &MujocoJoint::unnamed);
  if (first == joints.end()) return {};
  const auto count = static_cast<std::size_t>(std::ranges::count_if(joints, &MujocoJoint::unnamed));
  return count_text(count, "joint") + " of --model without a name, called by the place in the model: " + first->name +
         (count > 1 ? " and so on" : "");
}

Result<std::vector<TableColumn>> joint_columns(const std::vector<MujocoJoint>& joints,
                                               const std::array<const Array*, 2>& arrays, std::size_t steps,
                                               bool poses) {
  constexpr std::array<std::size_t (MujocoJoint::*)() const, 2> kCounts = {&MujocoJoint::positions,
                                                                           &MujocoJoint::velocities};
  constexpr std::array<std::string_view, 2> kFields = {"qpos", "qvel"};
  std::vector<TableColumn> columns;
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    const Array* array = arrays[i];
    if (array == nullptr) continue;
    std::size_t numbers = 0;
    for (const MujocoJoint& joint : joints) numbers += (joint.*kCounts[i])();
    if (array->shape != std::vector<std::size_t>{steps, numbers}) {
      return bad_input("array " + array->name + ": found the shape " + shape_text(array->shape) + ", wanted " +
                       shape_text({steps, numbers}) +
                       ", as the joints of --model give; is it the model of this session?");
    }
    std::size_t at = 0;
    for (const MujocoJoint& joint : joints) {
      const std::size_t n = (joint.*kCounts[i])();
      for (std::size_t c = 0; c < n; ++c, ++at) {
        const std::string name =
            std::string("world.") + std::string(kFields[i]) + '.' + joint.name + (n > 1 ? '.' + std::to_string(c) : "");
        columns.push_back({name, [array, at](std::size_t k, std::size_t) { return array->cell({k, at}); }});
      }
    }
  }
  if (!poses) return columns;
  const Array* qpos = arrays[0];
  constexpr std::array<std::string_view, 7> kParts = {"position.x",    "position.y",    "position.z",   "orientation.w",
                                                      "orientation.x", "orientation.y", "orientation.z"};
  for (std::size_t c = 0; c < kParts.size(); ++c) {
    columns.push_back({std::string(kParts[c]), [free = free_joints(joints), qpos, c](std::size_t k, std::size_t body) {
                         return qpos->cell({k, free[body].second + c});
                       }});
  }
  return columns;
}

}  // namespace tumble::replay
