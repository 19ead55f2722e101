#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tumble/golden/case_result.h"

/// How far a case is from what was blessed, and the words for it. Says "same" of bits alone: metrics within their
/// bounds may have moved.
namespace tumble::golden {

enum class Change : std::uint8_t {
  kNone = 0,          ///< no bit, no metric and no pixel moved
  kWithinBounds = 1,  ///< something moved, and every metric and picture is within its bounds
  kOutOfBounds = 2,   ///< a metric is out of its bounds, or a picture failed
  kNotJudged = 3,     ///< bits or metrics were not judged
};

/// Whether a metric failed though it lies within its bounds: with the same bits its golden has another value, so the
/// golden was edited or measured by another version.
bool differs_from_golden_alone(const MetricResult& metric);

Change change_of(const CaseResult& result);
const char* to_string(Change change);  ///< "unchanged", "moved within bounds", "out of bounds", "not judged"
const char* key_of(Change change);     ///< in JSON: "unchanged", "within_bounds", "out_of_bounds", "not_judged"

/// Whether a metric has another value than when it was blessed, by more than the spread of repeated runs, or a value
/// where there was none.
bool has_moved(const MetricResult& metric);
std::size_t moved_metrics(const CaseResult& result);

/// The metric that moved by the largest part of its bound or its value; null if none moved.
const MetricResult* most_moved(const std::vector<MetricResult>& metrics);

/// "0.1 m", "null".
std::string value_text(const std::optional<double>& value, const std::string& unit);

/// "bounces 15 → 14", "drift_max 0.1 m → 2.4 m", in as many digits as tell the two apart.
std::string movement_text(const MetricResult& metric);

/// The case in a line, magnitude first: "2.4 m apart (body 71, step 300), bits moved from step 45; 3 of 6 metrics moved
/// within bounds, most: bounces 15 → 14"; "same bits, 6 metrics unmoved"; "its process crashed: SIGSEGV".
std::string summary(const CaseResult& result);

}  // namespace tumble::golden
