#include "tools/compare/runs.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "golden/judge/judge_metrics.h"
#include "golden/suite/metric_values.h"
#include "golden/suite/parse_rules.h"
#include "replay/diff/separation.h"
#include "replay/measure/measure_log.h"
#include "replay/measure/metric_bound.h"
#include "replay/measure/parting.h"
#include "src/base/text.h"
#include "src/process/interrupt.h"
#include "tools/compare/runs_output.h"
#include "tools/compare/spread.h"
#include "tools/files/log_files.h"
#include "tools/output/progress.h"
#include "tumble/replay/comparison_scope.h"

namespace tumble::tools {
namespace {

using replay::Metrics;
using Values = std::vector<std::optional<double>>;

Error in_log(const std::string& path, const Error& error) { return {error.kind, path + ": " + error.message}; }

/// Opens one run after the other, and keeps what all of them have in common.
class Runs {
 public:
  explicit Runs(const std::vector<std::string>& logs) { facts_.logs = logs; }

  /// measure: of an open log. Errors: its own; logs that cannot be read, or have other axes than the first.
  template <class Measure>
  Status each(const Measure& measure) {
    const process::InterruptGuard guard;
    for (const std::string& path : facts_.logs) {
      Result<replay::LogReader> log = open_values(path);
      if (!log.ok()) return log.error();
      if (Status ok = compare_axes(path, *log); !ok.ok()) return ok.error();
      if (Status ok = measure(*log); !ok.ok()) return in_log(path, ok.error());
      const Result<Hash128> chain = log->chain_at(log->last_step());
      if (!chain.ok()) return chain.error();
      ++sessions_[{chain->high, chain->low}];
      steps_.insert(log->step_count());
      if (std::string note = replay::not_whole(*log); !note.empty()) facts_.notes.push_back(std::move(note));
      worst_ = judge("measure", *log, worst_);
    }
    facts_.different = sessions_.size();
    for (const auto& [session, times] : sessions_) facts_.once += times == 1 ? 1 : 0;
    if (steps_.size() > 1) {
      facts_.notes.push_back("the runs have from " + std::to_string(*steps_.begin()) + " to " +
                             count_text(*steps_.rbegin(), "step") + "; each is measured to its own end");
    }
    return {};
  }

  [[nodiscard]] RunsFacts& facts() { return facts_; }
  [[nodiscard]] Exit worst() const { return worst_; }

 private:
  Status compare_axes(const std::string& path, const replay::LogReader& log) {
    const replay::EngineAxes axes = log.header().axes();
    if (path == facts_.logs.front()) facts_.axes = axes;
    if (to_string(axes) == to_string(facts_.axes)) return {};
    return bad_input(path + ": found a session with the axes " + to_string(axes) + ", wanted runs of one scene, with " +
                     to_string(facts_.axes) + " as in " + facts_.logs.front());
  }

  RunsFacts facts_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::size_t> sessions_;  // how often, by the hash of all steps
  std::set<std::uint64_t> steps_;
  Exit worst_ = Exit::kSame;
};

/// All metrics that a run has: those of the list, of its channels and of --against.
std::vector<const replay::MetricRow*> metrics_of(const std::vector<Metrics>& runs) {
  std::vector<const replay::MetricRow*> rows;
  for (const replay::MetricRow& row : replay::metric_list()) rows.push_back(&row);
  const auto add = [&rows](const std::string& name) {
    const replay::MetricRow* row = replay::find_metric(name);
    if (row != nullptr && std::ranges::find(rows, row) == rows.end()) rows.push_back(row);
  };
  for (const Metrics& run : runs) {
    for (const replay::ChannelMetrics& channel : run.channels) {
      for (const char* statistic : replay::channel_statistic_names()) {
        add("channel." + channel.channel.name + "." + statistic);
      }
    }
    for (const replay::Parting& parting : run.partings) add("parting_time." + number_text(parting.beyond));
  }
  return rows;
}

/// The spreads of all metrics that have a value in any run.
std::vector<MetricSpread> spreads_of(const std::vector<Metrics>& runs, bool repeats) {
  std::vector<MetricSpread> spreads;
  for (const replay::MetricRow* row : metrics_of(runs)) {
    Values values;
    for (const Metrics& run : runs) values.push_back(row->value(run));
    const bool any = std::ranges::any_of(values, [](const std::optional<double>& value) { return value.has_value(); });
    if (any) spreads.push_back(spread_of(*row, std::move(values), repeats));
  }
  return spreads;
}

/// Prints the [[metric]]s of the names that --propose has.
/// Notes on the runs stand in comments before them: bounds of runs that were cut off hold for no whole one.
Status print_proposed(const RunsQuestion& question, const std::vector<std::string>& notes,
                      const std::vector<MetricSpread>& spreads) {
  std::string text;
  const std::string against = std::filesystem::path(question.against).filename().string();
  const auto add = [&](const MetricSpread& spread) {
    text += (text.empty() ? "" : "\n") +
            toml_of(spread, question.over, spread.metric->needs_other_session() ? against : "");
  };
  if (question.propose == "all") {
    for (const MetricSpread& spread : spreads) {
      if (spread.without_bound.empty()) add(spread);
    }
  } else {
    for (std::size_t at = 0; at <= question.propose.size();) {
      const std::size_t end = std::min(question.propose.find(',', at), question.propose.size());
      const std::string name = question.propose.substr(at, end - at);
      at = end + 1;
      const auto found =
          std::ranges::find_if(spreads, [&](const MetricSpread& spread) { return spread.metric->name == name; });
      if (found == spreads.end()) {
        return bad_input("--propose: found " + in_quotes(name) +
                         ", wanted \"all\" or names of metrics that the runs have, with commas between");
      }
      if (!found->without_bound.empty()) {
        return bad_input("--propose: no bound for " + name + ": " + found->without_bound);
      }
      add(*found);
    }
  }
  for (const std::string& note : notes) {
    std::cout << "# " << printable(note) << '\n';
    std::cerr << "tumble measure: note: " << printable(note) << '\n';
  }
  std::cout << text;
  return {};
}

Result<Exit> tell_spreads(const RunsQuestion& question) {
  if (question.logs.size() < 2) return bad_input("--propose: found one run, wanted several: one shows no spread");
  Runs runs(question.logs);
  std::vector<Metrics> all;
  const Status ok = runs.each([&](replay::LogReader& log) -> Status {
    const Result<replay::MeasureOptions> how = parse_measure(question.over, log.header().axes(), log.bodies());
    if (!how.ok()) return how.error();
    ProgressBar bar("measuring");
    Result<Metrics> metrics = replay::measure_log(log, *how, {}, bar.progress());
    bar.finish();
    if (!metrics.ok()) return metrics.error();
    if (Status measured = replay::check_measured(*metrics); !measured.ok()) return measured.error();
    if (!question.against.empty()) {
      Result<replay::LogReader> other = open_values(question.against);
      if (!other.ok()) return other.error();
      const std::vector<double> marks(replay::kSeparationMarks.begin(), replay::kSeparationMarks.end());
      Result<std::vector<replay::Parting>> partings = replay::measure_partings(log, *other, marks);
      if (!partings.ok()) return partings.error();
      metrics->partings = *std::move(partings);
    }
    for (const std::string& note : metrics->approximations) {
      std::vector<std::string>& notes = runs.facts().notes;
      if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
    }
    all.push_back(*std::move(metrics));
    return {};
  });
  if (!ok.ok()) return ok.error();
  const std::vector<MetricSpread> spreads = spreads_of(all, runs.facts().repeats());
  if (!question.propose.empty()) {
    if (Status printed = print_proposed(question, runs.facts().notes, spreads); !printed.ok()) return printed.error();
  } else if (question.json) {
    print_json("measure", spreads_json(runs.facts(), spreads));
  } else {
    print_spreads(runs.facts(), spreads);
  }
  return runs.worst();
}

/// The rules of a file that a log can be judged by without running a scene.
Result<golden::CaseRules> rules_of(const std::string& file, std::vector<std::string>& notes) {
  Result<golden::CaseRules> rules = golden::read_rules(file);
  if (!rules.ok()) return rules.error();
  std::erase_if(rules->metrics, [&](const golden::MetricRule& rule) {
    if (!golden::needs_transformed_scene(rule)) return false;
    notes.push_back(file + ": " + rule.name + " compares with a transformed scene; tumble check judges it");
    return true;
  });
  if (rules->metrics.empty())
    return bad_input("--bounds: found no metric in " + file + " that a log has alone, wanted one at least");
  return rules;
}

Result<Exit> judge_runs(const RunsQuestion& question) {
  Runs runs(question.logs);
  const Result<golden::CaseRules> rules = rules_of(question.bounds, runs.facts().notes);
  if (!rules.ok()) return rules.error();
  std::vector<JudgedBound> bounds;
  for (const golden::MetricRule& rule : rules->metrics) bounds.push_back({rule, {}, 0});
  const Status ok = runs.each([&](replay::LogReader& log) -> Status {
    golden::MetricSet metrics(log.header(), *rules);
    replay::StateSource states(log);
    replay::BodyStates last;
    ProgressBar bar("measuring");
    for (std::uint64_t k = log.first_state(); k <= log.last_step(); ++k) {
      const Result<const replay::StepRecord*> record = states.read(k);
      if (!record.ok()) return record.error();
      metrics.add(**record);
      if (k == log.last_step()) last = (*record)->states;
      if (process::InterruptGuard::interrupted()) return cannot_finish("interrupted");
    }
    bar.finish();
    const Result<Values> values = metrics.finish(last);
    if (!values.ok()) return values.error();
    for (std::size_t k = 0; k < bounds.size(); ++k) {
      bounds[k].values.push_back((*values)[k]);
      if (!golden::fault_of_value(bounds[k].rule, (*values)[k], "").empty()) ++bounds[k].broken;
    }
    return {};
  });
  if (!ok.ok()) return ok.error();
  question.json ? print_json("measure", bounds_json(runs.facts(), bounds)) : print_bounds(runs.facts(), bounds);
  const bool holds = std::ranges::all_of(bounds, [](const JudgedBound& bound) { return bound.broken == 0; });
  return holds || runs.worst() != Exit::kSame ? runs.worst() : Exit::kDifference;
}

}  // namespace

Result<Exit> measure_runs(const RunsQuestion& question) {
  std::set<std::string> paths;
  for (const std::string& path : question.logs) {
    if (path == question.against)
      return bad_input("--against: found " + path + ", which is one of the runs, wanted another session");
    if (!paths.insert(path).second) return bad_input("found " + path + " twice, wanted each run once");
  }
  return question.bounds.empty() ? tell_spreads(question) : judge_runs(question);
}

}  // namespace tumble::tools
