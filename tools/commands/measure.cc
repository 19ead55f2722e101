// tumble measure: symmetry, energy and stacking of a recorded session, in numbers.
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "replay/diff/separation.h"
#include "replay/measure/measure_log.h"
#include "replay/measure/metric_bound.h"
#include "replay/measure/mirrored_pair.h"
#include "src/files/output_guard.h"
#include "src/process/interrupt.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/arguments/measure_arguments.h"
#include "tools/compare/runs.h"
#include "tools/files/log_files.h"
#include "tools/output/gnuplot.h"
#include "tools/output/metrics_output.h"
#include "tools/output/plot.h"
#include "tools/output/progress.h"
#include "tools/output/text.h"
#include "tumble/replay/comparison_scope.h"
#include "tumble/replay/log_reader.h"

namespace tumble::tools {
namespace {

struct MeasureCommand {
  std::string log;
  std::vector<std::string> more;
  std::string series;
  std::string plot;
  MeasureArguments over;
  std::vector<std::string> require;
  std::string pair;
  std::string against;
  std::string propose;
  std::string bounds;
  bool json = false;

  /// Several runs, or one that is judged as one of several.
  [[nodiscard]] bool of_runs() const { return !more.empty() || !propose.empty() || !bounds.empty(); }
};

Result<std::vector<replay::MetricBound>> parse_bounds(const std::vector<std::string>& texts) {
  std::vector<replay::MetricBound> bounds;
  for (const std::string& text : texts) {
    Result<replay::MetricBound> bound = replay::parse_metric_bound(text);
    if (!bound.ok()) return bad_input("--require: " + bound.error().message);
    bounds.push_back(*std::move(bound));
  }
  return bounds;
}

// Prints the broken bounds to stderr.
Exit judge_bounds(const std::vector<replay::MetricBound>& bounds, const replay::EngineAxes& axes,
                  const replay::Metrics& metrics) {
  Exit verdict = Exit::kSame;
  for (const replay::MetricBound& bound : bounds) {
    if (bound.holds(bound.metric->value_in(axes, metrics))) continue;
    std::cerr << "tumble measure: " << bound.text << ": found " << bound.found_text(axes, metrics) << '\n';
    verdict = Exit::kDifference;
  }
  return verdict;
}

void warn_of_lost_bodies(const MeasureCommand& options, const replay::EngineAxes& axes,
                         const replay::Metrics& metrics) {
  if (!metrics.not_finite.any) return;
  std::cerr << "tumble measure: " << options.log << ": " << to_string(*metrics.not_finite.any, axes)
            << "; no metric over this body holds for any bound\n";
}

/// The parts of a log that no metric speaks of.
std::vector<std::string> notes_of(const replay::LogReader& log, const replay::Metrics& metrics) {
  std::vector<std::string> notes;
  if (std::string note = replay::not_whole(log); !note.empty()) notes.push_back(std::move(note));
  if (!metrics.told.empty()) notes.push_back(metrics.told);
  if (metrics.steps < log.last_step()) {
    notes.push_back("measured up to step " + std::to_string(metrics.steps) + " of " + std::to_string(log.last_step()) +
                    ": the steps behind the lost ones are not measured");
  }
  notes.insert(notes.end(), metrics.approximations.begin(), metrics.approximations.end());
  return notes;
}

Status check_outputs(const MeasureCommand& options) {
  files::OutputGuard guard;
  guard.keep(options.log, "the log that is measured");
  guard.keep(options.pair, "the log of --with");
  guard.keep(options.against, "the log of --against");
  if (!options.plot.empty()) {
    if (Status ok = check_plot_path(options.plot); !ok.ok()) return ok;
    if (Status ok = claim_output(guard, "--plot", options.plot, files::kind_by_name(options.plot)); !ok.ok()) return ok;
  }
  return options.series.empty() ? Status() : claim_output(guard, "--series", options.series, files::FileKind::kTable);
}

/// Measures, and writes every row to the files of --series and --plot.
Result<replay::Metrics> measure_rows(replay::LogReader& log, const replay::MeasureOptions& how,
                                     const MeasureCommand& options) {
  const process::InterruptGuard guard;
  ProgressBar bar("measuring");
  std::optional<SeriesFile> series;
  if (!options.series.empty()) {
    if (Status ok = series.emplace().open(options.series, log.header().declared.channels); !ok.ok()) return ok.error();
  }
  std::optional<Plot> plot;
  if (!options.plot.empty()) {
    Result<Plot> begun = Plot::for_file(options.plot, log.header().axes().unit(), log.header().declared.channels);
    if (!begun.ok()) return begun.error();
    plot = *std::move(begun);
  }
  Result<replay::Metrics> metrics = replay::measure_log(
      log, how,
      [&](const replay::SeriesRow& row) {
        const replay::SeriesRow shown = in_unit_of(log.header().axes(), row);
        if (series) series->add(shown);
        if (plot) plot->add(shown);
      },
      bar.progress());
  bar.finish();
  if (!metrics.ok()) return metrics;  // without the file's new name: the old one is whole, and this one is not
  if (series) {
    if (Status ok = series->close(); !ok.ok()) return ok.error();
  }
  if (!plot) return metrics;
  const sim::SceneDef& scene = log.header().scene;
  if (Status ok = plot->draw(scene.title.empty() ? scene.name : scene.name + ": " + scene.title); !ok.ok()) {
    return ok.error();
  }
  return metrics;
}

/// Adds the metrics of a mirrored pair.
Status compare_pair(replay::LogReader& log, replay::LogReader& pair, replay::Metrics& metrics) {
  const process::InterruptGuard guard;
  ProgressBar bar("comparing");
  const Result<replay::PairReport> report = replay::compare_mirrored_pair(log, pair, bar.progress());
  if (!report.ok()) return report.error();
  replay::set_pair_error(pair.header().transform, *report, metrics.symmetry);
  return {};
}

/// Adds the times at which the session parts from that of --against: at the distances that --require asks about, else
/// at those that `diff` marks.
Status compare_other(const MeasureCommand& options, const std::vector<replay::MetricBound>& bounds,
                     replay::LogReader& log, replay::Metrics& metrics) {
  std::vector<double> beyond;
  for (const replay::MetricBound& bound : bounds) {
    if (bound.metric->needs_other_session()) beyond.push_back(bound.metric->beyond);
  }
  if (options.against.empty()) {
    return beyond.empty() ? Status() : bad_input("--require: parting_time needs the other session: --against LOG");
  }
  if (beyond.empty()) beyond.assign(replay::kSeparationMarks.begin(), replay::kSeparationMarks.end());
  Result<replay::LogReader> other = open_values(options.against);
  if (!other.ok()) return other.error();
  const process::InterruptGuard guard;
  ProgressBar bar("comparing");
  Result<std::vector<replay::Parting>> partings = replay::measure_partings(log, *other, beyond, bar.progress());
  if (!partings.ok()) return partings.error();
  metrics.partings = *std::move(partings);
  return {};
}

Result<Exit> measure(const MeasureCommand& options) {
  const Result<std::vector<replay::MetricBound>> bounds = parse_bounds(options.require);
  if (!bounds.ok()) return bounds.error();
  if (Status ok = check_outputs(options); !ok.ok()) return ok.error();
  Result<replay::LogReader> log = open_values(options.log);
  if (!log.ok()) return log.error();
  const replay::EngineAxes axes = log->header().axes();
  const Result<replay::MeasureOptions> how = parse_measure(options.over, axes, log->bodies());
  if (!how.ok()) return how.error();
  std::optional<replay::LogReader> pair;
  if (!options.pair.empty()) {
    Result<replay::LogReader> opened = open_values(options.pair);
    if (!opened.ok()) return opened.error();
    pair.emplace(*std::move(opened));
  }
  Result<replay::Metrics> metrics = measure_rows(*log, *how, options);
  if (!metrics.ok()) return metrics.error();
  if (!bounds->empty()) {
    if (Status ok = replay::check_measured(*metrics); !ok.ok()) {
      return bad_input("--require: " + options.log + ": " + ok.error().message);
    }
  }
  if (pair) {
    if (Status ok = compare_pair(*log, *pair, *metrics); !ok.ok()) return ok.error();
  }
  if (Status ok = compare_other(options, *bounds, *log, *metrics); !ok.ok()) return ok.error();
  const std::vector<std::string> notes = notes_of(*log, *metrics);
  if (options.json) {
    Json json = metrics_json(options.log, axes, *metrics);
    json["notes"] = notes;
    print_json("measure", json);
  } else {
    for (const std::string& note : notes) std::cout << "note: " << printable(note) << '\n';
    print_metrics(options.log, axes, log->bodies(), *metrics);
  }
  warn_of_lost_bodies(options, axes, *metrics);
  const Exit verdict = judge("measure", *log, judge_bounds(*bounds, axes, *metrics));
  return pair ? judge("measure", *pair, verdict) : verdict;
}

Result<Exit> runs_of(const MeasureCommand& options) {
  if (!options.series.empty() || !options.plot.empty() || !options.pair.empty() || !options.require.empty()) {
    return bad_input(
        "of several runs: found an option that takes one log (--series, --plot, --with or --require), wanted none; "
        "--bounds FILE judges several");
  }
  const bool chosen = options.over.bodies != "all" || !options.over.axis.empty() || options.over.from_step;
  if (!options.bounds.empty() && (chosen || !options.against.empty())) {
    return bad_input(
        "--bounds: found --bodies, --axis, --from-step or --against beside it, wanted none: each [[metric]] of the "
        "file names its own");
  }
  RunsQuestion question = {{options.log}, options.over, options.against, options.propose, options.bounds, options.json};
  question.logs.insert(question.logs.end(), options.more.begin(), options.more.end());
  return measure_runs(question);
}

}  // namespace

Action declare_measure(Arguments& arguments) {
  auto options = std::make_shared<MeasureCommand>();
  arguments.positional("LOG", options->log, "The log to measure").required();
  arguments.positionals("MORE", options->more,
                        "Further runs of one scene: tells how far each metric differs among them, and proposes bounds");
  arguments.option("--series", "FILE.csv", options->series, "Also write the metrics of every step to this CSV file");
  arguments.option("--plot", "FILE.svg|png", options->plot,
                   "Also draw energy, heights and overlap over time, with gnuplot");
  add_measure(arguments, options->over);
  arguments
      .option("--require", "EXPR", options->require,
              "Exit with status 1 unless this holds, as in 'lateral_max<=0'; may be repeated")
      .offers(metric_words());
  arguments.option(
      "--with", "LOG", options->pair,
      "The log of the transformed scene (record --mirror, --permute, --shift): also measure the errors of the pair");
  arguments.option("--against", "LOG", options->against,
                   "Another session: also measure when a body is first further than D m from its place there, the "
                   "metric parting_time.D of --require");
  const Argument propose =
      arguments
          .option("--propose", "NAMES", options->propose,
                  "Of several runs: print bounds for these metrics, joined by commas, as [[metric]] of metrics.toml; "
                  "all: for each that has one")
          .offers({"all"});
  arguments
      .option("--bounds", "FILE", options->bounds,
              "Judge each run by the bounds of this metrics.toml, and count the runs that break each")
      .excludes(propose);
  arguments.json(options->json).excludes(propose);
  arguments.footer(
      "docs/metrics.md has the formula, unit and meaning of each metric.\n\n"
      "Examples:\n"
      "  tumble measure tilted_grid.tumble\n"
      "  tumble measure tilted_grid.tumble --json --series grid.csv\n"
      "  tumble measure brick_wall.tumble --plot wall.svg\n"
      "  tumble measure brick_wall.tumble --bodies wall --from-step 120\n"
      "  tumble measure brick_wall.tumble --require 'gain_ratio<=1e-3' --require 'lost<=0'\n"
      "  tumble measure brick_wall.tumble --with mirrored.tumble\n"
      "  tumble measure run_*.tumble\n"
      "  tumble measure run_*.tumble --propose drift_max,final >> golden/cases/crates/metrics.toml\n"
      "  tumble measure faulty_*.tumble --bounds golden/cases/crates/metrics.toml");
  return [options] { return options->of_runs() ? runs_of(*options) : measure(*options); };
}

}  // namespace tumble::tools
