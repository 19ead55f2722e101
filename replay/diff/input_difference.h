#pragma once

#include <optional>
#include <span>
#include <string>

#include "replay/diff/divergence.h"
#include "src/model/scene.h"

namespace tumble::replay {

/// Where the inputs of one step differ in two sessions.
struct InputDifference {
  /// "inputs" where their number or kinds differ; else the kind and the field: "throw.velocity.y", "push.impulse.x".
  std::string field;
  std::optional<sim::BodyId> body;  ///< that the input is about, where both mean the same one
  FieldValue expected;              ///< of "inputs": the kinds, in order
  FieldValue actual;
};

/// The first difference to the bit, in the fields that change what happens; look and origin do not.
std::optional<InputDifference> first_difference(std::span<const sim::Command> expected,
                                                std::span<const sim::Command> actual);

}  // namespace tumble::replay
