#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tumble/replay/field_value.h"
#include "tumble/replay/step_record.h"
#include "tumble/replay/tolerance.h"

namespace tumble::replay {

/// One key in which the headers of two logs differ.
struct HeaderDifference {
  /// "engine", "material.friction", "world.dt", "body 7 mass", "friction of bodies 1, 2, 3 and 219 more",
  /// "input 2 throw.velocity.y".
  std::string key;
  FieldValue a;
  FieldValue b;
  bool acts = false;     ///< a step may depend on it; names, looks and the program that wrote a log change none
  bool excused = false;  ///< by a tolerance
};

/// "material.friction: 0.4 → 0.400001".
std::string describe(const HeaderDifference& difference);

/// All keys in which two headers differ, with both values. Values that a step depends on stand behind the others.
/// Scenes of logs that begin with different states are not compared.
std::vector<HeaderDifference> header_differences(const LogHeader& a, const LogHeader& b,
                                                 const Tolerances& tolerances = {});

/// Likewise of two scenes: parameters of the world, bodies at the start, inputs, and what only pictures show.
std::vector<HeaderDifference> scene_differences(const sim::SceneDef& a, const sim::SceneDef& b,
                                                const Tolerances& tolerances = {});

/// The first difference that a step may depend on and that no tolerance excuses; null without one.
const HeaderDifference* first_cause(const std::vector<HeaderDifference>& differences);

/// Data that one of two logs of one engine has in its header and the other lacks: "channel knee", "phase hashes of
/// solve", "its shape of body 4". Nothing compared it.
struct OnlyInOne {
  std::vector<std::string> a;  ///< of the first log
  std::vector<std::string> b;  ///< of the second
  [[nodiscard]] bool empty() const { return a.empty() && b.empty(); }
  /// Whether the second has an input by name that the first had not.
  [[nodiscard]] bool adds_input() const;
  /// "only before.tumble has channel knee"; "the two differ in the shape of body 3" where each has one; else empty.
  [[nodiscard]] std::string text(const std::string& name_a, const std::string& name_b) const;
};

/// Channels, shapes of the bodies at the start, and phases with hashes of another engine, that one of two logs declares
/// and the other does not. Both are logs of one engine.
OnlyInOne only_in_one(const LogHeader& a, const LogHeader& b);

}  // namespace tumble::replay
