#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tumble/golden/case_result.h"
#include "tumble/golden/case_rules.h"

namespace tumble::golden {

/// The fault of a value by itself, whatever was blessed: null where that is not allowed, infinite or not a number, out
/// of its bounds. Empty: none.
std::string fault_of_value(const MetricRule& rule, const std::optional<double>& value, const std::string& unit);

/// Judges metrics by their bounds. same_bits: no bit of the session moved, so that no value may have either. values:
/// one a rule. Precondition: as many values as rules.
Verdict judge_metrics(const CaseRules& rules, const std::vector<std::optional<double>>& values, bool same_bits,
                      std::vector<MetricResult>& out);

}  // namespace tumble::golden
