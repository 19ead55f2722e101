#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "replay/blame/blame_answer.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/scene.h"

/// Where a value entered a session: an input, or a table of the scene.
namespace tumble::replay {

/// "push of body 7, impulse (4, 0, 0) N s".
std::string describe_input(const sim::Command& input);

/// The place of an input that is applied before step k: "line 12 of the scene, [[input]]"; "made live" where the scene
/// has no such input. Lines are of the scene's text, if the log holds it.
std::string input_place(const LogHeader& header, std::uint64_t k, const sim::Command& input);

/// The place of a body of the scene: "line 7 of the scene, [[box]]", "line 20 of the scene, [[wall]], row 3, column 2".
/// Empty where the scene does not define the body.
std::string body_place(const LogHeader& header, sim::BodyId body);

/// A value of a body, by the index of its field in BodyMotion.
struct ValueOfBody {
  sim::BodyId body = 0;
  std::size_t field = 0;
};

/// The answer that an input before step k changed the value; `before`: none where there was no such value.
BlameAnswer input_answer(const LogHeader& header, std::uint64_t k, const ValueOfBody& value,
                         const std::optional<FieldValue>& before, const FieldValue& after, const sim::Command& input);

/// The answer that the log starts with the value, in state k.
BlameAnswer start_answer(const LogHeader& header, std::uint64_t k, const ValueOfBody& value, const FieldValue& after);

/// The answer that the log holds the value after step k, but not the step.
BlameAnswer lost_answer(std::uint64_t k, const ValueOfBody& value, const FieldValue& after);

}  // namespace tumble::replay
