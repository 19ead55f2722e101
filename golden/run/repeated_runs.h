#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "replay/diff/separation.h"
#include "tumble/golden/judge.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

/// How the exact verdict begins where the runs of an engine differ among themselves.
inline constexpr std::string_view kDoesNotRepeat = "the engine does not repeat itself";

/// How a note begins on a bound that a run comes nearer to than the runs are to one another.
inline constexpr std::string_view kNearBound = "near a bound: ";

/// How often a case's engine runs: as often as the case says, and at least twice for a blessing of a case that requires
/// exact.
std::uint64_t runs_wanted(const CaseRules& rules, bool to_bless);

/// Several runs of an engine's case, judged together (`repeat`). Where they differ, the engine does not repeat itself
/// to the bit: the exact verdict fails, every metric has to hold its bounds in every run, its value is the median, and
/// it has moved only where the median is farther from the blessed value than the runs are from one another. A bound
/// that a run comes nearer to than that is named, for a further run may break it without any change.
class RepeatedRuns {
 public:
  /// first: the log of the first run, which `judged` is the judgement of. All must outlive this object.
  RepeatedRuns(replay::LogReader& first, const Reference& reference, Judged& judged);

  /// Adds another run. Errors: logs that cannot be compared.
  Status add(replay::LogReader& again);

  /// After the last run: completes `judged`.
  void finish();

 private:
  Status compare(replay::LogReader& again);
  void judge_metrics_of_all();
  void name_near_bounds();

  replay::LogReader& first_;
  const Reference& reference_;
  Judged& judged_;
  std::uint64_t runs_ = 1;
  std::vector<std::vector<std::optional<double>>> values_;  // one list a run
  std::string scope_;                                       // what was compared between two runs
  std::string difference_;                                  // of the first run that differs; empty: none does
  std::string near_;                                        // of bounds that a run comes near to; empty: of none
  std::optional<replay::SeparationRow> apart_;              // the largest separation of a run from the first
};

}  // namespace tumble::golden
