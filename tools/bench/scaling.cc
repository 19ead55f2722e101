// tumble bench scaling: how the time of a step grows with the number of bodies (the thesis's Fig. 25).
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "tools/bench/bench.h"
#include "tools/bench/peer_programs.h"
#include "tools/output/gnuplot.h"
#include "tumble/sim/step.h"
#include "tumble/sim/world.h"

namespace tumble::tools {
namespace {

constexpr double kBudget = 300;  // s

struct Point {
  std::string series;
  int rows = 0, columns = 0;
  double seconds = 0;  ///< CPU, of all steps

  [[nodiscard]] int bodies() const { return rows * columns; }
  [[nodiscard]] std::string name() const { return std::to_string(rows) + " x " + std::to_string(columns) + " cubes"; }
};

/// 20 rows of more and more columns; and the thesis's squares, whose piles get longer as well as wider.
std::vector<Point> all_points() {
  std::vector<Point> points;
  for (int columns = 20; columns <= 5120; columns *= 2) points.push_back({"20 rows", 20, columns});
  for (const int side : {6, 10, 15, 20, 40, 60, 80}) points.push_back({"squares", side, side});
  return points;
}

Result<double> run(const Point& point, const std::string& method) {
  const Result<sim::SceneDef> scene = bench_scene(
      "tilted_grid", {"world.method=" + method, "world.dt=0.03333333333333333", "world.substeps=4",
                      "grid.rows=" + std::to_string(point.rows), "grid.cols=" + std::to_string(point.columns)});
  if (!scene.ok()) return scene.error();
  Result<sim::World> world = sim::create_world(*scene);
  if (!world.ok()) return world.error();
  const double begin = cpu_seconds();
  for (std::uint64_t k = 1; k <= scene->steps; ++k) {
    if (const Result<sim::StepCounters> done = sim::step(*world); !done.ok()) return done.error();
  }
  return cpu_seconds() - begin;
}

Result<std::vector<double>> run_all(const Point& point, const std::string& method, std::uint64_t repeat) {
  std::vector<double> runs;
  for (std::uint64_t r = 0; r < repeat; ++r) {
    const Result<double> seconds = run(point, method);
    if (!seconds.ok()) return seconds.error();
    runs.push_back(*seconds);
  }
  return runs;
}

/// The slope of log time over log bodies, by least squares; from 400 bodies on. None of less than two points.
std::optional<double> exponent(const std::vector<Point>& points, const std::string& series) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Point& point : points) {
    if (point.series != series || point.bodies() < 400) continue;
    const double u = std::log(point.bodies()), v = std::log(point.seconds);
    n += 1;
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  if (n < 2) return std::nullopt;
  return (n * xy - x * y) / (n * xx - x * x);
}

Status plot(const std::vector<Point>& points, const std::string& path, const std::string& method) {
  if (Status ok = check_plot_path(path); !ok.ok()) return ok;
  std::string script =
      "set logscale xy\nset key left top\nset xlabel 'bodies'\nset ylabel 'CPU seconds for 5 s, dt 1/30'\n"
      "set title 'method " +
      method + "'\n";
  for (const char* series : {"20 rows", "squares"}) {
    script += std::string(series == std::string("squares") ? "$squares" : "$rows") + " << EOD\n";
    for (const Point& point : points) {
      if (point.series == series) script += std::to_string(point.bodies()) + ' ' + exact(point.seconds) + '\n';
    }
    script += "EOD\n";
  }
  script +=
      "stats $rows using 1:2 nooutput\nslope = STATS_min_y / STATS_min_x\n"
      "plot $rows with linespoints pointtype 7 title '20 rows', $squares with linespoints pointtype 6 title "
      "'squares', slope * x title 'linear' linecolor 'gray'\n";
  return run_gnuplot(path, 800, 600, script);
}

}  // namespace

Result<Exit> bench_scaling(const BenchOptions& options) {
  const std::string method = options.method.empty() ? "layered" : options.method;
  const double budget = options.budget.value_or(kBudget);
  std::vector<Point> points;
  Json results = {{"bench", "scaling"}, {"machine", machine_json()}, {"method", method}, {"points", Json::array()}};
  if (!options.json)
    std::cout << machine_text(results["machine"]) << "\nmethod " << method << ", 5 s at 1/30, 4 substeps\n";
  Table table({"series", ">bodies", ">CPU s", ">µs a body-step"});
  double spent = 0;
  FailedRuns failed;
  for (Point point : all_points()) {
    const bool goes_on = !points.empty() && points.back().series == point.series;
    const double expected = goes_on ? points.back().seconds * 1.3 * point.bodies() / points.back().bodies() : 0;
    if (spent + expected > budget) {
      table.add({point.series, std::to_string(point.bodies()), "left out, ~" + short_number(expected), ""});
      continue;
    }
    const Result<std::vector<double>> runs = run_all(point, method, options.repeat.value_or(1));
    if (!runs.ok()) {
      failed.add(point.name(), runs.error().message);
      table.add({point.series, std::to_string(point.bodies()), "failed", ""});
      continue;
    }
    spent += std::accumulate(runs->begin(), runs->end(), 0.0);
    point.seconds = median(*runs);
    points.push_back(point);
    const double each = point.seconds * 1e6 / (150.0 * point.bodies());
    table.add({point.series, std::to_string(point.bodies()), short_number(point.seconds), short_number(each)});
    results["points"].push_back({{"series", point.series},
                                 {"rows", point.rows},
                                 {"columns", point.columns},
                                 {"bodies", point.bodies()},
                                 {"cpu_s", point.seconds}});
  }
  for (const char* series : {"20 rows", "squares"}) {
    const std::optional<double> slope = exponent(points, series);
    results[std::string("exponent_") + (series[0] == '2' ? "rows" : "squares")] = slope ? Json(*slope) : Json(nullptr);
    if (slope) table.add({series, "from 400 on", "exponent " + short_number(*slope), ""});
  }
  if (!options.json) table.print();
  if (!options.json) failed.print();
  results["failures"] = failed.json();
  if (Status ok = give_results(options, results); !ok.ok()) return ok.error();
  if (!options.plot.empty() && !points.empty()) {
    if (Status ok = plot(points, options.plot, method); !ok.ok()) return ok.error();
  }
  if (Status ok = failed.status(); !ok.ok()) return ok.error();
  return Exit::kSame;
}

}  // namespace tumble::tools
