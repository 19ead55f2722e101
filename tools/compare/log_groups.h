#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "replay/diff/difference_report.h"
#include "tools/output/exit.h"
#include "tumble/replay/compare.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// Logs of runs that should agree (the peers of a lockstep game, repeated runs). Each two of them agree in all that
/// they share: a log that lacks a channel agrees with logs that do not agree with each other.
struct LogGroup {
  std::vector<std::size_t> logs;  ///< indices, ascending
  std::size_t longest = 0;        ///< the log that stands for the group
  std::size_t decided = 0;        ///< logs that agree with no other group
  replay::DiffReport against;     ///< of the first group's log and this one's; empty in the first group
  std::optional<replay::DifferenceReport> difference;  ///< likewise
};

struct LogGroups {
  std::vector<LogGroup> groups;        ///< by decided logs, the most first; of equal size, that of the earlier log
  std::vector<std::size_t> undecided;  ///< logs that agree with several groups: too short, or without a channel
  replay::ComparisonScope scope;       ///< of the comparisons between logs that agree
  bool same_length = false;            ///< all logs end with the same step
  std::vector<std::string> notes;      ///< for people: of each log that is not whole, or whose session may have gone on
  std::string not_in_all;  ///< for people: data that not all logs of a group have, and two of these logs; empty: none
  [[nodiscard]] bool identical() const { return groups.size() == 1 && same_length && not_in_all.empty(); }
  [[nodiscard]] bool has_majority() const { return groups.size() == 1 || groups[0].decided > groups[1].decided; }
};

/// Groups logs by their hashes, every byte of each read. Errors: diff_logs()'.
Result<LogGroups> group_logs(std::vector<replay::LogReader>& logs, const replay::Progress& progress = {});

/// `diff A B C …`: groups the logs, names the odd ones and the first difference of each.
Result<Exit> diff_many(const std::vector<std::string>& paths, bool json);

}  // namespace tumble::tools
