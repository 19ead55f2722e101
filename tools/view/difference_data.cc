#include "tools/view/difference_data.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "replay/diff/difference_report.h"
#include "replay/view/phase_partings.h"
#include "tools/output/difference_output.h"
#include "tools/output/divergence_output.h"
#include "tools/view/view_json.h"
#include "tumble/replay/compare.h"

namespace tumble::tools {
namespace {

constexpr std::size_t kSeparationRowsMax = 4000;  // of the separation; more are thinned, the largest of each run kept

Json separation_json(const replay::Separation& separation) {
  Json steps = Json::array(), metres = Json::array(), bodies = Json::array(), furthest = Json::array();
  const std::size_t run = separation.rows.size() / kSeparationRowsMax + 1;
  for (std::size_t i = 0; i < separation.rows.size(); i += run) {
    const auto begin = separation.rows.begin() + static_cast<std::ptrdiff_t>(i);
    const auto end = begin + static_cast<std::ptrdiff_t>(std::min(run, separation.rows.size() - i));
    const replay::SeparationRow& row = *std::max_element(
        begin, end, [](const auto& one, const auto& other) { return one.separation < other.separation; });
    steps.push_back(row.step);
    metres.push_back(short_json(row.separation));
    bodies.push_back(row.bodies);
    furthest.push_back(row.body ? Json(*row.body) : Json(nullptr));
  }
  return {{"step", steps}, {"metres", metres}, {"bodies", bodies}, {"body", furthest}};
}

Json partings_json(replay::LogReader& a, replay::LogReader& b, std::uint64_t from, const replay::Progress& progress) {
  const Result<replay::PhasePartings> found = replay::phase_partings(a, b, from, progress);
  if (!found.ok()) return {{"why_not", found.error().message}};
  Json rows = Json::array();
  for (const replay::PhaseParting& phase : found->phases) {
    rows.push_back({{"phase", printable(phase.phase)},
                    {"step", phase.step ? Json(*phase.step) : Json(nullptr)},
                    {"substep", phase.substep},
                    {"steps", phase.steps}});
  }
  return {{"from", found->from}, {"last", found->last}, {"rows", rows}, {"why_not", ""}};
}

}  // namespace

Result<Json> difference_data(replay::LogReader& a, replay::LogReader& b, const replay::Progress& progress) {
  Result<replay::DiffReport> report = replay::diff_logs(a, b, {}, progress);
  if (!report.ok()) return report.error();
  std::optional<replay::DifferenceReport> closer;
  if (report->first) {
    Result<replay::DifferenceReport> found = replay::report_difference(a, b, *report, progress);
    if (!found.ok()) return found.error();
    closer = *std::move(found);
    report->first = closer->first;
  }
  replay::name_by_own_axes(a.header(), b.header(), *report, closer ? &*closer : nullptr);
  Json json = comparison_json(report->identical(), report->steps, report->first);
  json["unequal"] = printable(report->unequal("A", "B"));
  json["state"] = "done";
  json["last"] = {report->last_a, report->last_b};
  json["notes"] = Json::array();
  for (const std::string& note : report->notes) json["notes"].push_back(printable(note));
  for (const replay::HeaderDifference& header : report->headers) json["notes"].push_back(printable(describe(header)));
  json["every_bit"] = report->scope.every_bit();
  json["compared"] = json["not_compared"] = Json::array();
  for (const std::string& part : report->scope.compared) json["compared"].push_back(printable(part));
  for (const std::string& part : report->scope.not_compared) json["not_compared"].push_back(printable(part));
  if (!closer) return json;
  json["first"] = divergence_json(closer->first);
  json["magnitude"] = replay::magnitude(closer->first);
  add_difference(*closer, Compared::kTwoLogs, json);
  json["cause"] = sides_of(a, b).named(closer->cause);
  if (closer->growth) {
    json["separation"] = separation_json(closer->growth->separation);
    json["aftermath"].erase("steps");
  } else {
    json["growth_unknown"] = printable(closer->growth_unknown);
  }
  json["partings"] = partings_json(a, b, closer->first.step, progress);
  return json;
}

}  // namespace tumble::tools
