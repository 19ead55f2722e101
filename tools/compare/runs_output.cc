#include "tools/compare/runs_output.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>

#include "src/base/text.h"
#include "tools/output/axes_output.h"

namespace tumble::tools {
namespace {

constexpr int kDigits = 5;

/// Lengths in the session's unit.
double shown(const replay::MetricRow& metric, const replay::EngineAxes& axes, double value) {
  return metric.is_length() ? axes.their_metres(value) : value;
}

std::string text_of(const replay::MetricRow& metric, const replay::EngineAxes& axes, double value) {
  return significant(shown(metric, axes, value), kDigits);
}

std::string bound_text(const replay::MetricRow& metric, const replay::EngineAxes& axes,
                       const std::optional<double>& min, const std::optional<double>& max) {
  if (min && max) return text_of(metric, axes, *min) + " to " + text_of(metric, axes, *max);
  return min ? "at least " + text_of(metric, axes, *min) : "at most " + text_of(metric, axes, *max);
}

void print_facts(const RunsFacts& facts) {
  for (const std::string& note : facts.notes) std::cout << "note: " << printable(note) << '\n';
  const std::string runs = std::to_string(facts.logs.size());
  Listing out;
  out.add("runs", facts.logs.size() == 1 ? runs
                  : facts.repeats()      ? runs + ", the same in every bit of their steps"
                                    : runs + ", " + std::to_string(facts.different) + " different ones among them");
  if (!facts.axes.ours()) out.add("axes", to_string(facts.axes));
  out.section("");
  out.print();
}

Json facts_json(const RunsFacts& facts) {
  return {{"runs", facts.logs}, {"different", facts.different}, {"once", facts.once}, {"axes", axes_json(facts.axes)}};
}

using Value = std::optional<double>;

Json number(const replay::MetricRow& metric, const replay::EngineAxes& axes, const Value& value) {
  return value ? number_json(shown(metric, axes, *value)) : Json(nullptr);
}

Json numbers(const replay::MetricRow& metric, const replay::EngineAxes& axes, const std::vector<Value>& values) {
  Json list = Json::array();
  for (const Value& value : values) list.push_back(number(metric, axes, value));
  return list;
}

bool has_number(const std::vector<Value>& values) {
  return std::ranges::any_of(values, [](const Value& value) { return value && std::isfinite(*value); });
}

/// "drift_max of 2 from step 60"
std::string name_of(const golden::MetricRule& rule) {
  std::string text = rule.name;
  if (rule.bodies != "all") text += " of " + rule.bodies;
  if (rule.has_axis) text += " along " + rule.axis;
  if (rule.from_step > 0) text += " from step " + std::to_string(rule.from_step);
  return text;
}

/// How many bounds fit, and their names: "2 in every run: a, b".
std::string list_of(const std::vector<JudgedBound>& bounds, const char* where,
                    const std::function<bool(const JudgedBound&)>& fits) {
  std::vector<std::string> names;
  for (const JudgedBound& bound : bounds) {
    if (fits(bound)) names.push_back(name_of(bound.rule));
  }
  return std::to_string(names.size()) + where + (names.empty() ? "" : ": " + joined(names, ", "));
}

}  // namespace

void print_spreads(const RunsFacts& facts, const std::vector<MetricSpread>& spreads) {
  print_facts(facts);
  Table table({"metric", "unit", ">least", ">median", ">largest", ">spread", "bounds proposed", ">unseen"});
  for (const MetricSpread& spread : spreads) {
    const replay::MetricRow& metric = *spread.metric;
    const auto text = [&](double value) { return text_of(metric, facts.axes, value); };
    const bool bounded = spread.without_bound.empty();
    if (!has_number(spread.values)) {
      table.add({metric.name, metric.unit_in(facts.axes), "", "", "", "", "none: " + spread.without_bound});
      continue;
    }
    table.add({metric.name, metric.unit_in(facts.axes), text(spread.least), text(spread.median), text(spread.largest),
               text(spread.spread()),
               bounded ? bound_text(metric, facts.axes, spread.min, spread.max) : "none: " + spread.without_bound,
               bounded ? text(spread.room) : ""});
  }
  table.print();
  std::cout
      << "\nunseen: a change of all runs by up to this may pass in every run; by more than this and the spread, it "
         "fails in every run.\n";
  if (facts.repeats()) return;
  const std::string runs = std::to_string(facts.logs.size()), further = std::to_string(facts.logs.size() + 1);
  std::cout << "Sessions that came once: " << facts.once << " of " << runs
            << " runs. About as often a further run is one "
            << "that was not seen; up to 2 times in " << further
            << " it is beyond\nthe least or the largest of a metric, so "
            << "the bounds are wider: by the spread, and by 1 % of the median at least.\n";
}

Json spreads_json(const RunsFacts& facts, const std::vector<MetricSpread>& spreads) {
  Json json = facts_json(facts);
  json["metrics"] = Json::array();
  for (const MetricSpread& spread : spreads) {
    const replay::MetricRow& metric = *spread.metric;
    const bool any = has_number(spread.values);
    const auto of = [&](const Value& value) { return number(metric, facts.axes, any ? value : std::nullopt); };
    const bool bounded = spread.without_bound.empty();
    json["metrics"].push_back({{"name", metric.name},
                               {"group", metric.group},
                               {"unit", metric.unit_in(facts.axes)},
                               {"values", numbers(metric, facts.axes, spread.values)},
                               {"least", of(spread.least)},
                               {"median", of(spread.median)},
                               {"largest", of(spread.largest)},
                               {"spread", of(spread.spread())},
                               {"min", of(spread.min)},
                               {"max", of(spread.max)},
                               {"unseen", of(bounded ? Value(spread.room) : std::nullopt)},
                               {"certain", of(bounded ? Value(spread.certain()) : std::nullopt)},
                               {"without_bound", spread.without_bound}});
  }
  json["notes"] = facts.notes;
  return json;
}

void print_bounds(const RunsFacts& facts, const std::vector<JudgedBound>& bounds) {
  print_facts(facts);
  const std::size_t runs = facts.logs.size();
  Table table({"metric", "unit", "bounds", ">least", ">largest", "broken"});
  for (const JudgedBound& bound : bounds) {
    const replay::MetricRow& metric = *replay::find_metric(bound.rule.name);
    const MetricSpread spread = spread_of(metric, bound.values, true);
    const bool any = has_number(bound.values);
    table.add(
        {name_of(bound.rule), metric.unit_in(facts.axes),
         bound_text(metric, facts.axes, bound.rule.min, bound.rule.max),
         any ? text_of(metric, facts.axes, spread.least) : "none",
         any ? text_of(metric, facts.axes, spread.largest) : "none",
         bound.broken == 0 ? "in no run" : "in " + std::to_string(bound.broken) + " of " + count_text(runs, "run")});
  }
  table.print();
  std::cout << "\nbroken " << list_of(bounds, " in every run", [&](const JudgedBound& b) { return b.broken == runs; })
            << '\n';
  if (runs > 1) {
    std::cout << "       "
              << list_of(bounds, " in some runs", [&](const JudgedBound& b) { return b.broken > 0 && b.broken < runs; })
              << '\n';
  }
  std::cout << "       " << std::ranges::count(bounds, std::size_t{0}, &JudgedBound::broken) << " in no run\n";
}

Json bounds_json(const RunsFacts& facts, const std::vector<JudgedBound>& bounds) {
  Json json = facts_json(facts);
  json["bounds"] = Json::array();
  for (const JudgedBound& bound : bounds) {
    const replay::MetricRow& metric = *replay::find_metric(bound.rule.name);
    json["bounds"].push_back({{"name", bound.rule.name},
                              {"bodies", bound.rule.bodies},
                              {"axis", bound.rule.axis},
                              {"from_step", bound.rule.from_step},
                              {"unit", metric.unit_in(facts.axes)},
                              {"min", number(metric, facts.axes, bound.rule.min)},
                              {"max", number(metric, facts.axes, bound.rule.max)},
                              {"values", numbers(metric, facts.axes, bound.values)},
                              {"broken", bound.broken}});
  }
  json["notes"] = facts.notes;
  return json;
}

}  // namespace tumble::tools
