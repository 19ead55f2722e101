#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "replay/blame/blame_answer.h"
#include "replay/blame/body_contacts.h"
#include "tools/output/text.h"
#include "tumble/replay/divergence.h"

namespace tumble::tools {

/// The account for people: one paragraph an answer, numbered.
void print_blame(const replay::Blame& blame);

/// {"body", "field", "step", "value", "unit", "answers": [answer…], "complete", "ends", "notes"}. An answer:
/// {"step", "substep" (null: once a step), "phase", "body", "contact" (null, or {"with": id, or null for the ground}),
/// "value", "unit", "before" (null: none), "after", "shares": [{"kind", "with" (of a contact; null: the ground),
/// "amount"}…], "exact" (before and shares add up to after, to the bit), "origin", "text"}. Numbers read back to the
/// same bits; text with all bits stands for values that are no finite numbers.
Json blame_json(const replay::Blame& blame);

/// "tumble blame b.tumble --body 7 --field velocity.x --step 12 --back 5" about a difference of a body's state; empty
/// for any other.
std::string blame_command(const std::string& log, const replay::Divergence& difference);

/// A table of contacts and points, the island, the load.
void print_contacts(const replay::BodyContacts& contacts);

/// {"body", "step", "mass", "island": [id…], "borne", "lent" (kg; null where the method keeps none), "contacts":
/// [{"substep", "with" (null: the ground), "normal" (towards the body), "impulse", "friction", "twist", "asleep",
/// "fast", "points":
/// [{"at", "depth", "impulse", "load"}…]}…], "notes"}.
Json contacts_json(const replay::BodyContacts& contacts);

}  // namespace tumble::tools
