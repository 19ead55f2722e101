#include "replay/diff/difference_report.h"

#include <utility>

namespace tumble::replay {

Result<DifferenceReport> report_difference(LogReader& a, LogReader& b, Divergence first, const Progress& progress) {
  DifferenceReport report;
  report.location = locate_divergence(a, b, first);
  report.first = std::move(first);
  Result<DivergenceGrowth> growth = growth_between(a, b, report.first.step, progress);
  if (growth.ok()) {
    report.growth = *std::move(growth);
    return report;
  }
  // A torn log may lack what growth needs, which is no news; a whole one must not.
  const bool whole = a.condition().whole() && b.condition().whole();
  if (growth.error().kind == ErrorKind::kDamaged && whole) return growth.error();
  report.growth_unknown = growth.error().message;
  return report;
}

DifferenceReport report_replay_difference(LogReader& log, LogReader* again, Divergence first,
                                          const Progress& progress) {
  DifferenceReport report;
  const bool has_step = first.step > log.first_state() && first.field != "error";
  if (has_step) report.location = locate_in_replay(log, first);
  report.first = std::move(first);
  if (!has_step || again == nullptr) return report;
  Result<DivergenceGrowth> growth = growth_in_replay(log, *again, report.first.step, progress);
  if (growth.ok()) {
    report.growth = *std::move(growth);
  } else {
    report.growth_unknown = growth.error().message;
  }
  return report;
}

}  // namespace tumble::replay
