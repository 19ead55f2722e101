// tumble measure: how a recorded session behaved, in numbers.
#include <functional>
#include <memory>
#include <string>

#include "replay/log_reader.h"
#include "replay/measure_log.h"
#include "tools/arguments.h"
#include "tools/command.h"
#include "tools/interrupt.h"
#include "tools/log_files.h"
#include "tools/metrics_output.h"
#include "tools/progress.h"
#include "tools/text.h"

namespace tumble::tools {
namespace {

struct Options {
  std::string log;
  std::string series;
  bool json = false;
};

Result<replay::Metrics> measure_with_series(replay::LogReader& log, const std::string& path) {
  const InterruptGuard guard;
  ProgressBar bar("measuring");
  const auto progress = [&](std::uint64_t done, std::uint64_t total) {
    bar.show(done, total);
    return !InterruptGuard::interrupted();
  };
  if (path.empty()) return replay::measure_log(log, {}, progress);
  SeriesFile series;
  if (Status ok = series.open(path); !ok.ok()) return ok.error();
  Result<replay::Metrics> metrics = replay::measure_log(
      log, [&](const replay::SeriesRow& row) { series.add(row); }, progress);
  if (Status ok = series.close(); !ok.ok()) return ok.error();
  return metrics;
}

Result<Exit> measure(const Options& options) {
  Result<replay::LogReader> log = open_log(options.log);
  if (!log.ok()) return log.error();
  const Result<replay::Metrics> metrics = measure_with_series(*log, options.series);
  if (!metrics.ok()) return metrics.error();
  if (options.json) {
    print_json(metrics_json(options.log, *metrics));
  } else {
    print_metrics(options.log, *metrics);
  }
  return judge("measure", *log, Exit::kSame);
}

}  // namespace

Action declare_measure(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("LOG", options->log, "The log to measure")->required()->type_name("");
  app.add_option("--series", options->series, "Also write the metrics of every step to this CSV file")
      ->type_name("FILE.csv");
  add_json(app, options->json);
  app.footer(
      "docs/metrics.md has the formula, unit and meaning of each metric.\n\n"
      "Examples:\n"
      "  tumble measure tilted_grid.tumble\n"
      "  tumble measure tilted_grid.tumble --json --series grid.csv");
  return [options] { return measure(*options); };
}

}  // namespace tumble::tools
