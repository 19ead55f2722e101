// tumble measure: how a recorded session behaved, in numbers.
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "replay/log_reader.h"
#include "replay/measure_log.h"
#include "replay/twin.h"
#include "src/model/limits.h"
#include "src/scenes/problem.h"
#include "tools/arguments.h"
#include "tools/command.h"
#include "tools/interrupt.h"
#include "tools/log_files.h"
#include "tools/metrics_output.h"
#include "tools/plot.h"
#include "tools/progress.h"
#include "tools/text.h"

namespace tumble::tools {
namespace {

struct Options {
  std::string log;
  std::string series;
  std::string plot;
  std::string bodies = "all";
  std::string axis = "x";
  std::optional<std::uint64_t> from_step;
  std::string twin;
  bool json = false;
};

Result<replay::MeasureOptions> measure_options(const Options& options) {
  replay::MeasureOptions how;
  Result<replay::BodyChoice> bodies = replay::parse_bodies(options.bodies);
  if (!bodies.ok()) return bad_input("--" + bodies.error().message);
  how.bodies = *std::move(bodies);
  if (options.axis != "x" && options.axis != "y") {
    return bad_input("--axis: found " + scenes::quoted(options.axis) + ", wanted x or y");
  }
  how.lateral = options.axis == "x" ? replay::LateralAxis::kX : replay::LateralAxis::kY;
  how.from_step = options.from_step.value_or(0);
  return how;
}

replay::Progress progress_on(ProgressBar& bar) {
  return [&bar](std::uint64_t done, std::uint64_t total) {
    bar.show(done, total);
    return !InterruptGuard::interrupted();
  };
}

/// Measures, and hands every row to the files that were asked for.
Result<replay::Metrics> measure_rows(replay::LogReader& log, const replay::MeasureOptions& how,
                                     const Options& options) {
  const InterruptGuard guard;
  ProgressBar bar("measuring");
  std::optional<SeriesFile> series;
  if (!options.series.empty()) {
    if (Status ok = series.emplace().open(options.series); !ok.ok()) return ok.error();
  }
  std::optional<Plot> plot;
  if (!options.plot.empty()) {
    Result<Plot> begun = Plot::for_file(options.plot);
    if (!begun.ok()) return begun.error();
    plot = *std::move(begun);
  }
  Result<replay::Metrics> metrics = replay::measure_log(
      log, how,
      [&](const replay::SeriesRow& row) {
        if (series) series->add(row);
        if (plot) plot->add(row);
      },
      progress_on(bar));
  bar.finish();
  if (series) {
    if (Status ok = series->close(); !ok.ok()) return ok.error();
  }
  if (!metrics.ok() || !plot) return metrics;
  const sim::SceneDef& scene = log.header().scene;
  if (Status ok = plot->draw(scene.title.empty() ? scene.name : scene.name + ": " + scene.title); !ok.ok()) {
    return ok.error();
  }
  return metrics;
}

/// Adds what only two sessions show.
Status compare_with_twin(replay::LogReader& log, replay::LogReader& twin, replay::Metrics& metrics) {
  const InterruptGuard guard;
  ProgressBar bar("comparing");
  const Result<replay::TwinReport> report = replay::compare_twins(log, twin, progress_on(bar));
  if (!report.ok()) return report.error();
  replay::set_twin_error(twin.header().transform, *report, metrics.symmetry);
  return {};
}

Result<Exit> measure(const Options& options) {
  const Result<replay::MeasureOptions> how = measure_options(options);
  if (!how.ok()) return how.error();
  Result<replay::LogReader> log = open_log(options.log);
  if (!log.ok()) return log.error();
  std::optional<replay::LogReader> twin;
  if (!options.twin.empty()) {
    Result<replay::LogReader> opened = open_log(options.twin);
    if (!opened.ok()) return opened.error();
    twin.emplace(*std::move(opened));
  }
  Result<replay::Metrics> metrics = measure_rows(*log, *how, options);
  if (!metrics.ok()) return metrics.error();
  if (twin) {
    if (Status ok = compare_with_twin(*log, *twin, *metrics); !ok.ok()) return ok.error();
  }
  if (options.json) {
    print_json(metrics_json(options.log, *metrics));
  } else {
    print_metrics(options.log, *metrics);
  }
  const Exit verdict = judge("measure", *log, Exit::kSame);
  return twin ? judge("measure", *twin, verdict) : verdict;
}

}  // namespace

Action declare_measure(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("LOG", options->log, "The log to measure")->required()->type_name("");
  app.add_option("--series", options->series, "Also write the metrics of every step to this CSV file")
      ->type_name("FILE.csv");
  app.add_option("--plot", options->plot, "Also draw energy, heights and overlap over time, with gnuplot")
      ->type_name("FILE.svg|png");
  app.add_option("--bodies", options->bodies,
                 "Measure these: ids (7), ranges (3-9), tables of the scene (grid, tower:1, input), joined by commas")
      ->type_name("LIST");
  app.add_option("--axis", options->axis, "The axis along which nothing should move: x (if not given) or y")
      ->type_name("AXIS");
  add_whole(app, "--from-step", options->from_step, 0, sim::kStepsMax,
            "Measure from the state after step K on, as if it were the start")
      ->type_name("K");
  app.add_option("--with", options->twin,
                 "The log of the scene's image (record --mirror, --permute, --shift): also say how far it is from one")
      ->type_name("LOG");
  add_json(app, options->json);
  app.footer(
      "docs/metrics.md has the formula, unit and meaning of each metric.\n\n"
      "Examples:\n"
      "  tumble measure tilted_grid.tumble\n"
      "  tumble measure tilted_grid.tumble --json --series grid.csv\n"
      "  tumble measure brick_wall.tumble --plot wall.svg\n"
      "  tumble measure brick_wall.tumble --bodies wall --from-step 120\n"
      "  tumble measure brick_wall.tumble --with mirrored.tumble");
  return [options] { return measure(*options); };
}

}  // namespace tumble::tools
