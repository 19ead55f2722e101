#pragma once

#include <cstdint>

#include "replay/blame/blame_answer.h"
#include "replay/blame/origin.h"
#include "replay/blame/steps_again.h"
#include "tumble/sim/result.h"

/// The places where the chain of answers ends. Each function adds its answers to the account, as many as were asked
/// for, and the reason why the chain stops there. Errors: those of StepsAgain.
namespace tumble::replay {

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
