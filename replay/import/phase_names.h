#pragma once

#include <string>
#include <vector>

#include "tumble/sim/result.h"

namespace tumble::replay {

/// Errors (kBadInput): more phases than a log has, one without a name, two of one name: an answer that names the phase
/// would be of both.
Status check_phase_names(const std::vector<std::string>& phases);

}  // namespace tumble::replay
