#include "replay/log/checked_log.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace tumble::replay {

Result<VerifyReport> check_log(LogReader& log, const Progress& progress) {
  VerifyReport report = verify(log, progress);
  if (!report.complete) return cannot_finish("interrupted");
  const std::vector<Damage>& known = log.condition().damages;
  const auto is_known = [&](const Damage& damage) {
    return std::ranges::any_of(
        known, [&](const Damage& one) { return one.kind == damage.kind && one.offset == damage.offset; });
  };
  std::vector<Damage> found;
  std::ranges::remove_copy_if(report.condition.damages, std::back_inserter(found), is_known);
  if (found.empty()) return report;
  const std::string& first = found.front().message;
  const std::string more = found.size() == 1 ? "" : "; and " + std::to_string(found.size() - 1) + " more damages";
  return damaged((first.starts_with(log.name()) ? "" : log.name() + ": ") + first + more +
                 "; 'tumble info' lists them, 'tumble recover' saves the rest");
}

Result<const VerifyReport*> CheckedLogs::check(LogReader& log, const Progress& progress) {
  if (const auto at = reports_.find(&log); at != reports_.end()) return &at->second;
  Result<VerifyReport> report = check_log(log, progress);
  if (!report.ok()) return report.error();
  return &(reports_[&log] = *std::move(report));
}

}  // namespace tumble::replay
