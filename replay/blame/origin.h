#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "replay/blame/blame_answer.h"
#include "replay/blame/steps_again.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

/// Where a value entered a session: an input, a table of the scene, a step that the log lacks.
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

// The places where the chain of answers ends. Each function adds its answers to the account, as many as were asked for,
// and the reason why the chain stops there. Errors: those of StepsAgain.

/// Inputs before step k changed the value; the last of them stands first.
Status end_at_inputs(StepsAgain& steps, std::uint64_t k, const ValueOfBody& value, Blame& blame);

/// Both bodies of the contact that acted in step k were at rest.
Status end_at_rest(StepsAgain& steps, std::uint64_t k, const ValueOfBody& value, Blame& blame);

/// The log begins with state k.
Status end_at_start(StepsAgain& steps, std::uint64_t k, const ValueOfBody& value, Blame& blame);

/// The log holds the value after step k, in a keyframe, and not the step. `why`: StepsAgain::has_step's; another error
/// than that a step is lost or damaged is returned as it is.
Status end_at_lost_step(StepsAgain& steps, std::uint64_t k, const ValueOfBody& value, const Error& why, Blame& blame);

}  // namespace tumble::replay
