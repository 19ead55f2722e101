#pragma once

#include <optional>
#include <string>

#include "replay/diff/difference_report.h"
#include "tools/bisect/bisection.h"
#include "tools/output/text.h"
#include "tumble/replay/compare.h"

namespace tumble::tools::bisect {

/// The sessions of the closest good and the first bad revision, compared.
struct Comparison {
  replay::DiffReport report;
  std::optional<replay::DifferenceReport> difference;
  std::string not_compared;  ///< the reason if they could not be compared; else empty
};

/// Errors go to `not_compared`.
Comparison compare_sessions(const Finding& finding, const Workplace& place);

void print_verdict(const Settings& settings, const Finding& finding, const Comparison& comparison);
Json verdict_json(const Settings& settings, const Finding& finding, const Comparison& comparison);

/// "good  1a2b3c4d5e  2026-11-21  subject: the same in every bit (12.3 s)".
std::string tested_text(const Tested& tested);

}  // namespace tumble::tools::bisect
