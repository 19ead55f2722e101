// tumble bench table1: the thesis's Table I with this program's method `thesis`, beside the thesis's and Havok's
// columns, and beside other engines that take as many substeps as ours did.
#include "tools/bench/table1.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

#include "golden/suite/temporary_folder.h"
#include "replay/measure/measure.h"
#include "tools/bench/bench.h"
#include "tools/bench/peer_programs.h"
#include "tumble/sim/step.h"
#include "tumble/sim/world.h"

namespace tumble::tools {
namespace {

std::vector<Table1Cell> all_cells() {
  std::vector<Table1Cell> cells;
  for (std::size_t half = 0; half < thesis_table1().size(); ++half) {
    for (std::size_t row = 0; row < kTableSubsteps.size(); ++row) {
      for (std::size_t column = 0; column < kTableCubes.size(); ++column) {
        Table1Cell cell;
        cell.half = half;
        cell.row = row;
        cell.column = column;
        cells.push_back(cell);
      }
    }
  }
  return cells;
}

std::vector<std::string> overrides_of(const Table1Cell& cell, double dt_s, std::uint64_t substeps) {
  const std::string side = std::to_string(std::lround(std::sqrt(cell.cubes())));
  return {"world.dt=" + exact(dt_s), "world.substeps=" + std::to_string(substeps), "grid.rows=" + side,
          "grid.cols=" + side};
}

/// Steps the scene; the time is that of the steps alone, the figures are of the first and the last state.
Status run(const sim::SceneDef& scene, Table1Cell& cell) {
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
  std::uint64_t substeps = 0;
  cell.substeps_largest = 0;
  const double begin = cpu_seconds();
  for (std::uint64_t k = 1; k <= scene.steps; ++k) {
    const Result<sim::StepCounters> done = sim::step(*world);
    if (!done.ok()) return done.error();
    counters = *done;
    substeps += counters.substeps;
    cell.substeps_largest = std::max(cell.substeps_largest, counters.substeps);
  }
  cell.seconds = cpu_seconds() - begin;
  cell.substeps_mean = static_cast<double>(substeps) / static_cast<double>(scene.steps);
  const replay::StepRecord last = record(counters);
  measurer.add(last);
  const Result<replay::Metrics> metrics = measurer.finish(last.states);
  if (!metrics.ok()) return metrics.error();
  cell.lateral = metrics->symmetry.lateral_max;
  cell.spread = metrics->symmetry.column_spread;
  cell.lost = metrics->stacking.lost;
  return {};
}

/// CPU seconds spent so far, and the rate of the last run: a run that would pass the budget is left out.
struct Spent {
  double seconds = 0;
  std::optional<double> rate;  ///< s for a unit of work

  [[nodiscard]] bool has_room(double work, const BenchOptions& options) const {
    return !options.budget || !rate || seconds + work * *rate <= *options.budget;
  }
  void add(double taken, double work) {
    seconds += taken;
    rate = taken / work;
  }
};

class Table1Run {
 public:
  Table1Run(const BenchOptions& options, sim::Method method, std::filesystem::path folder, std::vector<Peer> peers)
      : options_(options),
        method_(method),
        folder_(std::move(folder)),
        peers_(std::move(peers)),
        peers_spent_(peers_.size()) {}

  /// Runs a cell and its peers in turn, if the budget allows each of them.
  Status run_cell(Table1Cell& cell) {
    for (const Peer& peer : peers_) cell.peers.push_back({peer.word, 0, std::nullopt, ""});
    if (!ours_[cell.half].has_room(cell.thesis(), options_)) return {};
    std::vector<std::string> overrides = overrides_of(cell, cell.dt(), static_cast<std::uint64_t>(cell.label()));
    overrides.push_back(std::string("world.method=") + name_of(method_));
    const Result<sim::SceneDef> scene = bench_scene("tilted_grid", overrides);
    if (!scene.ok()) return scene.error();
    std::vector<double> runs;
    std::vector<std::vector<double>> peer_runs(peers_.size());
    for (std::uint64_t r = 0; r < options_.repeat.value_or(1); ++r) {
      if (Status ok = run(*scene, cell); !ok.ok()) return ok;
      runs.push_back(*cell.seconds);
      for (Spent& half : ours_) half.seconds += *cell.seconds;
      for (std::size_t k = 0; k < peers_.size(); ++k) run_peer(cell, k, peer_runs[k]);
    }
    cell.seconds = median(runs);
    ours_[cell.half].rate = *cell.seconds / cell.thesis();
    for (std::size_t k = 0; k < peers_.size(); ++k) {
      const PeerCell& peer = cell.peers[k];
      if (!peer_runs[k].empty()) cell.peers[k].seconds = median(peer_runs[k]);
      if (peer.failure.empty()) continue;
      failed_.add(peers_[k].word + " in " + count_text(static_cast<std::uint64_t>(cell.cubes()), "cube") + " with " +
                      count_text(peer.substeps, "substep"),
                  peer.failure);
    }
    return {};
  }

  [[nodiscard]] const FailedRuns& failed() const { return failed_; }

 private:
  /// An engine that fails has no time in this cell.
  void run_peer(Table1Cell& cell, std::size_t k, std::vector<double>& runs) {
    PeerCell& out = cell.peers[k];
    if (!out.failure.empty()) return;
    out.substeps = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::lround(cell.substeps_mean)));
    const double work = static_cast<double>(cell.cubes()) * static_cast<double>(out.substeps) / cell.dt();
    if (!peers_spent_[k].has_room(work, options_)) return;
    const bool takes_substeps = peers_[k].is_ours();
    const double dt_s = takes_substeps ? cell.dt() : cell.dt() / static_cast<double>(out.substeps);
    const Result<Json> done = run_for_json(peer_command(peers_[k], bench_scene_path("tilted_grid"),
                                                        overrides_of(cell, dt_s, takes_substeps ? out.substeps : 1)),
                                           folder_);
    if (!done.ok()) {
      out.failure = done.error().message;
      runs.clear();
      return;
    }
    out.engine = (*done)["engine"];
    if (takes_substeps) out.engine += ' ' + peers_[k].word;
    runs.push_back((*done)["cpu_s"]);
    peers_spent_[k].add(runs.back(), work);
  }

  const BenchOptions& options_;
  sim::Method method_;
  std::filesystem::path folder_;
  std::vector<Peer> peers_;
  std::vector<Spent> peers_spent_;
  FailedRuns failed_{" of engines"};
  std::array<Spent, 2> ours_;  // of each half; both know all that was spent
};

}  // namespace

Result<Exit> bench_table1(const BenchOptions& options) {
  const sim::Method method = options.method == "layered" ? sim::Method::kLayered : sim::Method::kThesis;
  const std::vector<std::string> asked = options.engines.empty() ? std::vector<std::string>{"none"} : options.engines;
  Result<PeerChoice> choice = choose_peers({"thesis", "layered", "bullet", "ode", "mujoco"}, asked);
  if (!choice.ok()) return choice.error();
  const golden::TemporaryFolder folder("tumble-bench");
  if (folder.path().empty()) return cannot_finish("no temporary folder for the other engines");
  std::vector<Table1Cell> cells = all_cells();
  std::ranges::sort(cells, {}, &Table1Cell::thesis);  // the cheap ones first: a budget then covers as many as it can
  Table1Run runs(options, method, folder.path(), std::move(choice->peers));
  for (Table1Cell& cell : cells) {
    if (Status ok = runs.run_cell(cell); !ok.ok()) return ok.error();
  }
  // The first cell names the engines; each engine ran in the cheapest one at least.
  for (Table1Cell& cell : cells) {
    for (std::size_t k = 0; k < cell.peers.size(); ++k) cell.peers[k].engine = cells.front().peers[k].engine;
  }
  std::ranges::sort(cells, {}, [](const Table1Cell& c) { return std::tuple(c.half, c.column, c.row); });
  Json results = {{"bench", "table1"},
                  {"machine", machine_json()},
                  {"method", name_of(method)},
                  {"repeat", options.repeat.value_or(1)}};
  results.update(table1_json(cells, method));
  if (!options.json) {
    std::cout << machine_text(results["machine"]) << "\nmethod " << results["method"].get<std::string>()
              << "; substeps: as labelled, the most that a step may take, the mean that it took; F: bodies were lost\n";
    print_table1(cells, method);
  }
  if (Status ok = give_results(options, results); !ok.ok()) return ok.error();
  if (Status ok = runs.failed().status(); !ok.ok()) return ok.error();
  return Exit::kSame;
}

}  // namespace tumble::tools
