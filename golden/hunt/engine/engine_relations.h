#pragma once

#include <string>

#include "golden/hunt/judge/relation.h"

/// Relations between two sessions of an engine: the same scene again, transformed, or with its bodies in another order.
namespace tumble::hunt {

/// Judges a relation, not a law, on a session of an engine. Not applicable: a relation between parts of Tumble alone.
Judgement judge_engine(const std::string& relation, const Trace& trace);

}  // namespace tumble::hunt
