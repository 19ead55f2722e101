// tumble bench table1: the thesis's Table I with this program's method `thesis`, beside the thesis's and Havok's
// columns.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "replay/measure/measure.h"
#include "tools/bench/bench.h"
#include "tools/bench/thesis_table1.h"
#include "tumble/sim/step.h"
#include "tumble/sim/world.h"

namespace tumble::tools {
namespace {

constexpr double kCellBudget = 120;  // s

/// One cell of the table, and its result here.
struct Cell {
  std::size_t half = 0, row = 0, column = 0;
  double seconds = 0;
  bool estimated = false;  ///< beyond the budget
  double lateral = 0;      ///< m
  std::optional<double> spread;
  std::uint64_t lost = 0;

  [[nodiscard]] double thesis() const { return *thesis_table1()[half].thesis[row][column].seconds; }
};

std::vector<Cell> all_cells() {
  std::vector<Cell> cells;
  for (std::size_t half = 0; half < thesis_table1().size(); ++half) {
    for (std::size_t row = 0; row < kTableSubsteps.size(); ++row) {
      for (std::size_t column = 0; column < kTableCubes.size(); ++column) {
        Cell cell;
        cell.half = half;
        cell.row = row;
        cell.column = column;
        cells.push_back(cell);
      }
    }
  }
  return cells;
}

Result<sim::SceneDef> scene_of(const Cell& cell, const std::string& method) {
  const int side = static_cast<int>(std::lround(std::sqrt(kTableCubes[cell.column])));
  return bench_scene("tilted_grid", {"world.method=" + method, "world.dt=" + exact(thesis_table1()[cell.half].dt),
                                     "world.substeps=" + std::to_string(kTableSubsteps[cell.row]),
                                     "grid.rows=" + std::to_string(side), "grid.cols=" + std::to_string(side)});
}

/// Steps the scene; time is that of the steps alone, the figures are of the first and the last state.
Status run(const sim::SceneDef& scene, Cell& cell) {
  Result<sim::World> world = sim::create_world(scene);
  if (!world.ok()) return world.error();
  const auto record = [&](const sim::StepCounters& counters) {
    replay::StepRecord step;
    step.step = world->state().step;
    step.dt = scene.world.dt;
    step.counters = counters;
    step.has_states = true;
    replay::copy_visible(world->bodies(), step.states);
    return step;
  };
  replay::MeasureOptions options;
  options.overlap_every = 0;
  replay::Measurer measurer(replay::header_for(scene), options);
  measurer.add(record({}));
  sim::StepCounters counters;
  const double begin = cpu_seconds();
  for (std::uint64_t k = 1; k <= scene.steps; ++k) {
    const Result<sim::StepCounters> done = sim::step(*world);
    if (!done.ok()) return done.error();
    counters = *done;
  }
  cell.seconds = cpu_seconds() - begin;
  const replay::StepRecord last = record(counters);
  measurer.add(last);
  const Result<replay::Metrics> metrics = measurer.finish(last.states);
  if (!metrics.ok()) return metrics.error();
  cell.lateral = metrics->symmetry.lateral_max;
  cell.spread = metrics->symmetry.column_spread;
  cell.lost = metrics->stacking.lost;
  return {};
}

std::string reference(const TableTime& time) {
  if (!time.seconds) return "N/A";
  return short_number(*time.seconds) + (time.failed ? " F" : "");
}

void print(const std::vector<Cell>& cells) {
  for (std::size_t half = 0; half < thesis_table1().size(); ++half) {
    const TableHalf& table1 = thesis_table1()[half];
    std::cout << "\nconstant time " << table1.name << " s; seconds of computation for 5 s\n";
    Table table({">cubes", ">substeps", ">here", ">thesis", ">thesis / here", ">Havok", ">Havok / here", ">lateral",
                 ">column spread"});
    for (const Cell& cell : cells) {
      if (cell.half != half) continue;
      const TableTime& havok = table1.havok[cell.row][cell.column];
      const std::string mark = cell.estimated ? "~" : "";
      table.add({std::to_string(kTableCubes[cell.column]), std::to_string(kTableSubsteps[cell.row]),
                 mark + short_number(cell.seconds) + (cell.lost > 0 ? " F" : ""), short_number(cell.thesis()),
                 mark + short_number(cell.thesis() / cell.seconds), reference(havok),
                 havok.seconds ? mark + short_number(*havok.seconds / cell.seconds) : "",
                 cell.estimated ? "" : rounded(cell.lateral, "m"),
                 cell.estimated || !cell.spread ? "" : rounded(*cell.spread, "m")});
    }
    table.print();
  }
}

Json to_json(const std::vector<Cell>& cells) {
  Json out = Json::array();
  for (const Cell& cell : cells) {
    const TableTime& havok = thesis_table1()[cell.half].havok[cell.row][cell.column];
    out.push_back({{"cubes", kTableCubes[cell.column]},
                   {"substeps", kTableSubsteps[cell.row]},
                   {"dt", thesis_table1()[cell.half].dt},
                   {"cpu_s", cell.seconds},
                   {"estimated", cell.estimated},
                   {"thesis_s", cell.thesis()},
                   {"ratio", cell.thesis() / cell.seconds},
                   {"havok_s", havok.seconds ? Json(*havok.seconds) : Json(nullptr)},
                   {"havok_failed", havok.failed},
                   {"lost", cell.lost},
                   {"lateral_max", cell.estimated ? Json(nullptr) : Json(cell.lateral)},
                   {"column_spread", cell.spread ? Json(*cell.spread) : Json(nullptr)}});
  }
  return out;
}

}  // namespace

Result<Exit> bench_table1(const BenchOptions& options) {
  const std::string method = options.method.empty() ? "thesis" : options.method;
  const double budget = options.budget.value_or(kCellBudget);
  std::vector<Cell> cells = all_cells();
  std::ranges::sort(cells, {}, &Cell::thesis);  // the cheap ones first, so that they say what the others will cost
  double spent = 0;
  std::map<std::size_t, double> share;  // of each half: the part of the thesis's time that the last cell took
  for (Cell& cell : cells) {
    // The first of each half runs whatever budget is left: the estimates of the others need it.
    const auto known = share.find(cell.half);
    const double expected = known == share.end() ? 0 : cell.thesis() * known->second;
    cell.estimated = known != share.end() && spent + expected > budget;
    cell.seconds = expected;
    if (cell.estimated) continue;
    std::vector<double> runs;
    const Result<sim::SceneDef> scene = scene_of(cell, method);
    if (!scene.ok()) return scene.error();
    for (std::uint64_t r = 0; r < options.repeat.value_or(1); ++r) {
      if (Status ok = run(*scene, cell); !ok.ok()) return ok.error();
      runs.push_back(cell.seconds);
      spent += cell.seconds;
    }
    cell.seconds = median(runs);
    share[cell.half] = cell.seconds / cell.thesis();
  }
  std::ranges::sort(cells, {}, [](const Cell& c) { return std::tuple(c.half, c.column, c.row); });
  double log_sum = 0, least = INFINITY, left = 0;
  std::size_t counted = 0;
  for (const Cell& cell : cells) {
    if (cell.estimated) left += cell.seconds;
    if (cell.estimated) continue;
    ++counted;
    log_sum += std::log(cell.thesis() / cell.seconds);
    least = std::min(least, cell.thesis() / cell.seconds);
  }
  const double mean = std::exp(log_sum / static_cast<double>(std::max<std::size_t>(counted, 1)));
  const Json results = {{"bench", "table1"},    {"machine", machine_json()}, {"method", method},
                        {"cells_run", counted}, {"estimated_rest_s", left},  {"ratio_geometric_mean", mean},
                        {"ratio_least", least}, {"cells", to_json(cells)}};
  if (!options.json) {
    std::cout << machine_text(results["machine"]) << "\nmethod " << method << "; ~ is an estimate, beyond --budget "
              << short_number(budget) << " s; F: bodies were lost\n";
    print(cells);
    std::cout << "\n"
              << counted << " of " << cells.size() << " cells run, the others would take about " << seconds_text(left)
              << "; faster than the thesis's figures by " << short_number(mean) << " times in the geometric mean, by "
              << short_number(least) << " times at least\n";
  }
  if (Status ok = give_results(options, results); !ok.ok()) return ok.error();
  return Exit::kSame;
}

}  // namespace tumble::tools
