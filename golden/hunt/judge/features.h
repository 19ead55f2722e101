#pragma once

#include <string>
#include <vector>

#include "golden/hunt/judge/trace.h"

namespace tumble::hunt {

/// What happened in a session, as words, ascending, each once: "layered: an island falls asleep", "thesis: 8 contacts
/// or more". A corpus keeps a scene for each.
std::vector<std::string> features_of(const Trace& trace);

}  // namespace tumble::hunt
