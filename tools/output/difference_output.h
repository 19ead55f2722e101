#pragma once

#include <cstdint>

#include "replay/diff/difference_report.h"
#include "tools/output/divergence_output.h"
#include "tools/output/text.h"

namespace tumble::tools {

/// The two sessions of a report.
enum class Compared : std::uint8_t {
  kTwoLogs,  ///< called "A" and "B"
  kReplay,   ///< a log, and this build's replay of it
};

/// Prints a report for people: cause and first effect, the first difference, its location, its growth.
void print_difference(const replay::DifferenceReport& report, Compared compared, const Sides& sides);

/// Adds "cause", "effect", the location ("narrowed", of two logs) and the growth ("aftermath", where it is known) to
/// the JSON that comparison_json() began.
void add_difference(const replay::DifferenceReport& report, Compared compared, Json& json);

/// Parts of the two above.
void print_growth(const replay::DivergenceGrowth& growth, const Sides& sides);
/// {"kind":…, "marks":[…], "lost":…, "contacts_from":…, "freezing_from":…, "bodies_from":…, "largest":{…}, "last":{…},
/// "metrics":[…], "steps":[…]}.
Json growth_json(const replay::DivergenceGrowth& growth);
/// The log whose first different step this build takes alike, and the contacts of the first body in that step.
void print_location(const replay::DivergenceLocation& location, const Sides& sides);
/// {"this_build_follows":…, "bodies":[…], "contacts":[…]}.
Json location_json(const replay::DivergenceLocation& location);

}  // namespace tumble::tools
