#pragma once

#include "replay/diff/aftermath.h"
#include "replay/diff/locate_divergence.h"
#include "tools/output/text.h"

namespace tumble::tools {

/// What a first difference led to, for people. a, b: what the two sides are called in a table, "A" and "B".
void print_aftermath(const replay::Aftermath& aftermath, const char* a, const char* b);

/// {"kind":…, "marks":[…], "contacts_from":…, "freezing_from":…, "bodies_from":…, "largest":{…}, "last":{…},
/// "metrics":[…], "steps":[…]}.
Json aftermath_json(const replay::Aftermath& aftermath);

/// Whom this build follows in the first different step, and what the first body touched there.
void print_narrowing(const replay::Narrowing& narrowing);
Json narrowing_json(const replay::Narrowing& narrowing);

}  // namespace tumble::tools
