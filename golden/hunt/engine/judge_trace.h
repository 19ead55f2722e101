#pragma once

#include <string>

#include "golden/hunt/judge/relation.h"

namespace tumble::hunt {

/// The judgement of a relation or law on a session, of this program or of an engine. A session that ended early is
/// judged by `finishes` alone. Precondition: find_relation(name) is not null.
Judgement judge_trace(const std::string& name, const Trace& trace);

}  // namespace tumble::hunt
