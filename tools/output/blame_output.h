#pragma once

#include <nlohmann/json_fwd.hpp>

#include "replay/blame/blame.h"
#include "tools/output/text.h"

namespace tumble::tools {

/// The account for people: one paragraph an answer, numbered.
void print_blame(const replay::Blame& blame);

/// {"body", "field", "step", "value", "unit", "answers": [answer…], "complete", "ends", "notes"}. An answer:
/// {"step", "substep" (null: once a step), "phase", "body", "contact" (null, or {"with": id, or null for the ground}),
/// "value", "unit", "before" (null: none), "after", "shares": [{"kind", "with" (of a contact; null: the ground),
/// "amount"}…], "exact" (before and shares add up to after, to the bit), "origin", "text"}. Numbers read back to the
/// same bits; text with all bits stands for values that are no finite numbers.
Json blame_json(const replay::Blame& blame);

}  // namespace tumble::tools
