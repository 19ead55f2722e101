#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/sim/result.h"

/// How far a measure may be apart in one scene's sessions by two builds that need not compute the same bits.
namespace tumble::hunt {

/// The relation of two builds, of which each bound adds one (relation_of()).
inline constexpr const char* kAgainst = "against";

/// The measure that is no metric: the farthest that a body is from its place in the other session, m, up to the first
/// contact of either session. Behind a contact a difference of a rounding grows to one of metres.
inline constexpr const char* kPlace = "place";

struct ApartBound {
  std::string measure;  ///< kPlace, or a metric of docs/metrics.md
  double amount = 0;    ///< in the measure's unit
  double part = 0;      ///< of the larger of both values, besides
  [[nodiscard]] double allowed(double a, double b) const;
  friend bool operator==(const ApartBound&, const ApartBound&) = default;
};

/// The bounds of `--within bounds`. docs/hunting.md says why these measures and how far.
std::vector<ApartBound> usual_bounds();

/// Reads the words of --within. "bits" alone, or no word: none, every bit is compared. "bounds": usual_bounds().
/// "METRIC=AMOUNT", "METRIC=PART%" or "METRIC=AMOUNT+PART%": that measure, in the place of the usual bound where there
/// is one. Errors (kBadInput): any other word; a metric that two sessions of builds cannot be compared by; one twice.
Result<std::vector<ApartBound>> read_bounds(const std::vector<std::string>& words);

/// "overlap_peak=0.002+10%", which read_bounds() reads again.
std::string to_text(const ApartBound& bound);

/// "m", "J"; empty for ratios.
std::string unit_of(const ApartBound& bound);

/// The relation of a measure, "against_overlap_peak"; the measure of a relation, none where it is of no measure.
std::string relation_of(const ApartBound& bound);
std::optional<std::string> measure_of(std::string_view relation);

}  // namespace tumble::hunt
