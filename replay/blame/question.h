#pragma once

#include <string>
#include <vector>

#include "replay/blame/blame_answer.h"
#include "replay/blame/steps_again.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// The component of position that changed most in step k; of velocity where the body did not move. Requires a body that
/// body_asked() found.
Result<std::string> field_changed_most(StepsAgain& steps, sim::BodyId body, std::uint64_t k);

/// The value that a question is about. Errors (kBadInput): a field, a step or a body that does not exist, with the
/// reason where the log knows one; a log of another engine.
Result<double> value_asked(StepsAgain& steps, const BlameQuestion& question);

/// Likewise for the body and the step alone.
Result<BodyMotion> body_asked(StepsAgain& steps, sim::BodyId body, std::uint64_t k);

}  // namespace tumble::replay
