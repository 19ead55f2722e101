#include "replay/diff/difference_report.h"

#include <algorithm>
#include <utility>

#include "replay/diff/input_difference.h"
#include "replay/format/engine_column.h"
#include "replay/log/hashes_only.h"
#include "replay/session/state_source.h"
#include "src/base/check.h"
#include "src/base/text.h"
#include "tumble/replay/tolerance.h"

namespace tumble::replay {
namespace {

std::string values_text(const Divergence& d) {
  if (is_body_missing(d)) return "body " + std::to_string(*d.body) + " is " + only_in(d, "A", "B");
  const HeaderDifference shown = {d.field, d.expected, d.actual, true, false};
  return (d.body ? "body " + std::to_string(*d.body) + ' ' : "") + describe(shown);
}

constexpr const char* kOtherAxes =
    "the two logs have other axes, or other units: fields are named z up, right-handed, m";

/// A value by the table's axis and unit.
void shown_in(const EngineAxes& axes, const EngineColumn& column, FieldValue& value) {
  auto* number = std::get_if<double>(&value);
  if (number == nullptr) return;
  if (column.sign < 0) *number = -*number;
  if (column.is_length) *number = axes.their_metres(*number);
}

void shown_in(const EngineAxes& axes, HeaderDifference& header) {
  const std::size_t end = std::min(header.key.find(" of bodies "), header.key.size());  // "position.y of bodies 2, 3"
  const std::optional<EngineColumn> column = column_in(axes, header.key.substr(0, end));
  if (!column) return;
  header.key = column->name + header.key.substr(end);
  for (FieldValue* value : {&header.a, &header.b}) shown_in(axes, *column, *value);
}

/// The difference in the first of the rows in which bodies differ: a changed input or counter may show later. What
/// diff_logs() counts as equal in another engine's states is none. None where both sessions end before.
std::optional<Divergence> effect_in(LogReader& a, LogReader& b, const std::vector<SeparationRow>& rows) {
  const PhaseMatch phases = match_phases(a.header(), b.header());
  const bool imported = a.header().engine || b.header().engine;
  StateSource in_a(a), in_b(b);
  for (const SeparationRow& row : rows) {
    if (row.bodies == 0) continue;
    const Result<const StepRecord*> one = in_a.read(row.step), other = in_b.read(row.step);
    if (!one.ok() || !other.ok()) return std::nullopt;
    StepRecord expected = **one, actual = **other;
    // What led into the step is the cause, and not asked for here; but no phase comes before it.
    const bool by_inputs =
        expected.dt != actual.dt || first_difference(std::span(expected.inputs), std::span(actual.inputs));
    actual.dt = expected.dt;
    actual.inputs = expected.inputs;
    match_phase_words(phases, a.header(), b.header(), expected, actual);
    if (imported) forgive_zeros(expected, actual);
    forgive_derived(derived_values(a.header(), b.header()), expected, actual);
    std::optional<Divergence> found = first_difference(expected, actual, phases.names);
    if (!found || !is_in_state(*found)) continue;
    if (by_inputs) {
      found->phase = "inputs";
      found->substep.reset();
    }
    if (in_binary32(a.header(), b.header())) count_in_binary32(*found);
    if (found->step == a.first_state()) found->phase = "start";
    return found;
  }
  return std::nullopt;
}

}  // namespace

// A parameter explains an input that differs (a material of the scene is also that of a thrown box), and not the other
// way round.
std::string cause_of(const DiffReport& found, const Divergence& first) {
  if (found.built) return "one scene, but two worlds built from it: " + values_text(*found.built);
  const HeaderDifference* cause = first_cause(found.headers);
  const bool is_parameter = cause != nullptr && !cause->key.starts_with("input");
  if (is_parameter) return describe(*cause);
  if (first.phase == "inputs") return "before step " + std::to_string(first.step) + ", " + values_text(first);
  if (cause != nullptr) return describe(*cause);
  const auto excused = std::ranges::find_if(found.headers, &HeaderDifference::excused);
  if (excused != found.headers.end()) return describe(*excused);
  if (first.phase == "start" || first.field == "steps") return "not in the headers: " + values_text(first);
  if (first.pair && first.field == "contacts") {
    return "step " + std::to_string(first.step) + " came out otherwise: contact of " +
           std::to_string(first.pair->first) + " and " +
           (first.pair->second == 0 ? "the ground" : std::to_string(first.pair->second)) + ": " + first.note;
  }
  const bool result = first.phase == "step" || first.phase == "channels" || first.phase == "contacts";
  if (result) return "step " + std::to_string(first.step) + " came out otherwise: " + values_text(first);
  return "scene and inputs are equal; phase " + first.phase + " was computed otherwise";
}

Result<DifferenceReport> report_difference(LogReader& a, LogReader& b, const DiffReport& found,
                                           const Progress& progress) {
  SIM_CHECK(found.first.has_value(), found.steps);
  DifferenceReport report;
  report.first = *found.first;
  report.location = locate_divergence(a, b, report.first);
  report.cause = cause_of(found, report.first);
  if (is_in_state(report.first) || report.first.field == "error") report.effect = report.first;
  if (lack_states(a.header(), b.header())) {
    report.growth_unknown = "a log holds hashes and no places of bodies";
    return report;
  }
  const std::uint64_t until = std::min(found.last_a, found.last_b);
  Result<DivergenceGrowth> growth = growth_between(a, b, report.first.step, progress, until);
  if (growth.ok()) {
    report.growth = *std::move(growth);
    if (!report.effect) report.effect = effect_in(a, b, report.growth->separation.rows);
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
  report.cause = first.phase == "start" ? "this build makes another world of the scene: " + values_text(first)
                 : first.phase == "step" || first.phase == "inputs"
                     ? values_text(first)
                     : "this build computes phase " + first.phase + " otherwise";
  if (is_in_state(first)) report.effect = first;
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

EngineAxes common_axes(const LogHeader& a, const LogHeader& b) {
  EngineAxes in_a = a.axes(), in_b = b.axes();
  in_a.metres = in_b.metres = 1;
  return in_a == in_b ? in_a : EngineAxes();
}

Divergence in_axes(const EngineAxes& axes, Divergence difference) {
  if (axes.ours()) return difference;
  const std::optional<EngineColumn> column = column_in(axes, difference.field);
  if (!column) return difference;
  difference.field = column->name;
  for (FieldValue* value : {&difference.expected, &difference.actual}) shown_in(axes, *column, *value);
  return difference;
}

LostBody in_axes(const EngineAxes& axes, LostBody lost) {
  if (const auto column = column_in(axes, lost.field)) lost.field = column->name;
  return lost;
}

void name_by_own_axes(const LogHeader& a, const LogHeader& b, DiffReport& found, DifferenceReport* report) {
  const EngineAxes axes = common_axes(a, b);
  if (axes.ours()) {
    if (!(a.axes() == b.axes()) && found.first) found.notes.emplace_back(kOtherAxes);
    return;
  }
  found.notes.push_back("fields are named by the engine's axes: " + to_string(axes));
  if (found.first) found.first = in_axes(axes, *std::move(found.first));
  if (found.built) found.built = in_axes(axes, *std::move(found.built));
  for (HeaderDifference& header : found.headers) shown_in(axes, header);
  if (report == nullptr) return;
  report->first = in_axes(axes, std::move(report->first));
  if (report->effect) report->effect = in_axes(axes, *std::move(report->effect));
  if (found.first) report->cause = cause_of(found, *found.first);  // which names the field too
  if (report->growth && report->growth->separation.lost) {
    report->growth->separation.lost = in_axes(axes, *std::move(report->growth->separation.lost));
  }
}

std::string DiffReport::though() const {
  const auto acting = std::ranges::count_if(headers, &HeaderDifference::acts);
  if (first || acting == 0) return "";
  return "though the headers differ in " + count_text(static_cast<std::uint64_t>(acting), "value") +
         " that a step depends on: see the header lines";
}

std::string DiffReport::behind() const {
  return until == kNoLimit ? "" : "all behind step " + std::to_string(until) + ", as asked";
}

std::string DiffReport::unequal(const std::string& name_a, const std::string& name_b) const {
  if (first) return "";
  std::string text;
  if (last_a != last_b) {
    text = "another number of steps, " + std::to_string(last_a) + " and " + std::to_string(last_b);
  }
  const std::string parts = only_in.text(name_a, name_b);
  return text + (text.empty() || parts.empty() ? "" : "; ") + parts;
}

}  // namespace tumble::replay
