#pragma once

#include <string>
#include <vector>

#include "golden/hunt/judge/trace.h"

namespace tumble::hunt {

/// What happened in a session, as words, ascending, each once: "layered: an island falls asleep", "thesis: 8 contacts
/// or more"; and of a session of this program that ran to its end, how near it came to the bound of each law:
/// "layered: energy reaches 90 % of its bound". A corpus keeps a scene for each.
std::vector<std::string> features_of(const Trace& trace);

}  // namespace tumble::hunt
