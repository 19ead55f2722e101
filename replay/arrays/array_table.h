#pragma once

#include <functional>
#include <string>
#include <vector>

#include "replay/arrays/mujoco_model.h"
#include "replay/arrays/npz.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

struct ArrayOptions {
  bool scalar_last = false;                                   ///< quaternions of the arrays are x y z w; else w x y z
  std::vector<MujocoJoint> joints = {};                       ///< of the model of an array qpos; empty without a model
  std::function<void(const std::string& warning)> warn = {};  ///< called for what the table has no place for
};

/// The table, as import_csv() reads it, that an archive of arrays stands for. Steps are the first dimension of each
/// array that changes, bodies the second. docs/other_engines.md names the arrays. Every number is kept to the bit.
///
/// Without positions, the free joints of `joints` give the poses of the bodies; every other number of qpos and qvel
/// becomes a channel of the world with the name of its joint. name: for messages. Errors (kBadInput): no positions,
/// arrays whose shapes do not fit one another.
Result<std::string> table_of_arrays(const std::vector<Array>& arrays, const std::string& name,
                                    const ArrayOptions& options);

}  // namespace tumble::replay
