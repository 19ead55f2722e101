#pragma once

#include <optional>
#include <span>
#include <string>

#include "tumble/replay/field_value.h"
#include "tumble/sim/scene.h"

namespace tumble::replay {

/// The first difference between the inputs that two sessions have before one step.
struct InputDifference {
  /// "inputs" where their number or kinds differ; else kind and field: "throw.velocity.y", "push.impulse.x".
  std::string field;
  std::optional<sim::BodyId> body;  ///< the body that the input acts on, where both inputs act on one body
  FieldValue expected;              ///< for "inputs": the kinds, in order
  FieldValue actual;
};

/// Compares to the bit the fields that change the simulation. Look and origin of a thrown box are not compared.
std::optional<InputDifference> first_difference(std::span<const sim::Command> expected,
                                                std::span<const sim::Command> actual);

}  // namespace tumble::replay
