// tumble bench accuracy: how far each engine's rows of cubes lie from its own converged solution, for each dt and
// number of substeps of the thesis.
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "golden/suite/temporary_folder.h"
#include "replay/measure/measure_log.h"
#include "tools/bench/bench.h"
#include "tools/bench/peer_programs.h"
#include "tools/bench/row_distribution.h"
#include "tools/bench/table1.h"
#include "tumble/replay/log_reader.h"

namespace tumble::tools {
namespace {

/// One length of step, and the substeps of each.
struct Setting {
  int per_second;  ///< steps
  int substeps;

  [[nodiscard]] double work() const { return static_cast<double>(per_second) * substeps; }
};

/// The finest first: the converged solution, one with steps of twice the length, which tells how well it has
/// converged, then the thesis's own settings.
constexpr std::array<Setting, 12> kSettings = {{{3000, 8},
                                                {3000, 4},
                                                {30, 1},
                                                {30, 4},
                                                {30, 10},
                                                {30, 40},
                                                {30, 200},
                                                {300, 1},
                                                {300, 4},
                                                {300, 10},
                                                {300, 40},
                                                {300, 200}}};

struct AccuracyRun {
  bool ran = false;
  double seconds = 0;  ///< CPU
  RowDistribution rows;
  std::optional<double> from_limit;  ///< m, distance from the engine's finest run
  double lateral = 0;                ///< m
  std::optional<double> spread;      ///< m, of columns
};

struct EngineAccuracy {
  Peer peer;
  std::string engine;  ///< "Bullet 3.24"
  std::array<AccuracyRun, kSettings.size()> runs;
  std::string failure;  ///< of one of its runs, after which there is none

  [[nodiscard]] const RowDistribution& limit() const { return runs.front().rows; }
  [[nodiscard]] std::uint32_t most(const Setting& setting) const {
    return most_substeps(setting.substeps, peer.word == "thesis" ? sim::Method::kThesis : sim::Method::kLayered);
  }
};

class AccuracySession {
 public:
  AccuracySession(std::string side, std::filesystem::path folder)
      : side_(std::move(side)), folder_(std::move(folder)) {}

  /// Runs one setting. An engine without substeps gets steps of their length.
  Status run(EngineAccuracy& engine, std::size_t k) const {
    const Setting& setting = kSettings[k];
    const bool has_substeps = engine.peer.is_ours();
    const double dt_s = has_substeps ? 1.0 / setting.per_second : 1.0 / setting.work();
    std::vector<std::string> overrides = {"world.dt=" + exact(dt_s), "grid.rows=" + side_, "grid.cols=" + side_};
    overrides.push_back("world.substeps=" + std::to_string(has_substeps ? setting.substeps : 1));
    const std::string path = (folder_ / "end.tumble").string();
    std::vector<std::string> words = peer_command(engine.peer, bench_scene_path("tilted_grid"), overrides);
    // Only the last state counts, but a step of a log is at most a second long.
    const auto every = std::max<long>(1, std::lround(0.5 / dt_s));
    words.insert(words.end(), {"--log", path, "--every", std::to_string(every)});
    const Result<Json> done = run_for_json(std::move(words), folder_);
    if (!done.ok()) return done.error();
    AccuracyRun& out = engine.runs[k];
    out.ran = true;
    out.seconds = (*done)["cpu_s"];
    engine.engine = (*done)["engine"];
    if (has_substeps) engine.engine += ' ' + engine.peer.word;
    return read(path, overrides, out);
  }

 private:
  static Status read(const std::string& path, const std::vector<std::string>& overrides, AccuracyRun& out) {
    const Result<sim::SceneDef> scene = bench_scene("tilted_grid", overrides);
    if (!scene.ok()) return scene.error();
    Result<replay::LogReader> log = replay::LogReader::open(path);
    if (!log.ok()) return log.error();
    const Result<replay::Metrics> metrics = replay::measure_log(*log);
    if (!metrics.ok()) return metrics.error();
    out.lateral = metrics->symmetry.lateral_max;
    out.spread = metrics->symmetry.column_spread;
    const Result<const replay::StepRecord*> last = log->read_step(log->last_step());
    if (!last.ok()) return last.error();
    out.rows = distribution_of(*scene, (*last)->states);
    return {};
  }

  std::string side_;
  std::filesystem::path folder_;
};

/// Runs an engine's settings, cheap ones first, as far as the budget goes and the engine does not fail.
void run_engine(const AccuracySession& session, const BenchOptions& options, EngineAccuracy& engine) {
  std::array<std::size_t, kSettings.size()> order{};
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::ranges::stable_sort(order, {}, [](std::size_t k) { return kSettings[k].work(); });
  double spent = 0, rate = 0;
  for (const std::size_t k : order) {
    const double work = kSettings[k].work();
    // An engine without substeps takes the same steps in two of the thesis's settings.
    const auto equal = std::ranges::find_if(order, [&](std::size_t j) {
      return !engine.peer.is_ours() && engine.runs[j].ran && kSettings[j].work() == work;
    });
    if (equal != order.end()) {
      engine.runs[k] = engine.runs[*equal];
      continue;
    }
    if (options.budget && spent + rate * work > *options.budget) continue;
    if (Status ok = session.run(engine, k); !ok.ok()) {
      engine.failure = "dt 1/" + std::to_string(kSettings[k].per_second) + ", " +
                       count_text(static_cast<std::uint64_t>(kSettings[k].substeps), "substep") + ": " +
                       ok.error().message;
      engine.runs[k] = {};
      break;
    }
    spent += engine.runs[k].seconds;
    rate = engine.runs[k].seconds / work;
  }
  for (AccuracyRun& run : engine.runs) run.from_limit = distance(run.rows, engine.limit());
}

std::string length_text(const std::optional<double>& value) { return value ? rounded(*value, "m") : "–"; }

void print(const EngineAccuracy& engine) {
  std::cout << '\n' << engine.engine << '\n';
  Table table({">dt", ">substeps", ">most", ">CPU s", ">mean of y", ">farthest row", ">from the limit", ">lateral",
               ">column spread", ">lost"});
  const std::size_t all = engine.limit().y.size();
  for (std::size_t k = 0; k < kSettings.size(); ++k) {
    const Setting& setting = kSettings[k];
    const AccuracyRun& run = engine.runs[k];
    const std::string dt = "1/" + std::to_string(setting.per_second);
    const std::string most = std::to_string(engine.most(setting));
    if (!run.ran) {
      table.add({dt, std::to_string(setting.substeps), most, "not run", "", "", "", "", "", ""});
      continue;
    }
    table.add({dt, std::to_string(setting.substeps), most, short_number(run.seconds), fixed(run.rows.mean, 2) + " m",
               fixed(run.rows.farthest, 1) + " m", run.from_limit ? fixed(*run.from_limit, 2) + " m" : "–",
               length_text(run.lateral), length_text(run.spread),
               std::to_string(all > 0 ? all - run.rows.y.size() : 0)});
  }
  table.print();
  if (!engine.failure.empty()) std::cout << "failed at " << printable(engine.failure) << '\n';
  std::cout.flush();
}

Json to_json(const EngineAccuracy& engine) {
  Json out = {{"engine", engine.engine}, {"failure", engine.failure}};
  out["runs"] = Json::array();
  for (std::size_t k = 0; k < kSettings.size(); ++k) {
    const AccuracyRun& run = engine.runs[k];
    const auto value = [&](const std::optional<double>& x) { return run.ran && x ? number_json(*x) : Json(nullptr); };
    out["runs"].push_back({{"dt", 1.0 / kSettings[k].per_second},
                           {"substeps", kSettings[k].substeps},
                           {"substeps_most", engine.most(kSettings[k])},
                           {"cpu_s", value(run.seconds)},
                           {"mean_y", value(run.rows.mean)},
                           {"farthest_row", value(run.rows.farthest)},
                           {"from_limit", value(run.from_limit)},
                           {"lateral_max", value(run.lateral)},
                           {"column_spread", value(run.spread)},
                           {"y", run.rows.y}});
  }
  return out;
}

/// Distances between the converged solutions.
Json limits_json(const std::vector<EngineAccuracy>& engines) {
  Json out = Json::array();
  for (std::size_t a = 0; a < engines.size(); ++a) {
    for (std::size_t b = a + 1; b < engines.size(); ++b) {
      const std::optional<double> apart = distance(engines[a].limit(), engines[b].limit());
      out.push_back(
          {{"engines", {engines[a].engine, engines[b].engine}}, {"distance", apart ? Json(*apart) : Json(nullptr)}});
    }
  }
  return out;
}

}  // namespace

Result<Exit> bench_accuracy(const BenchOptions& options) {
  const Result<std::string> side = grid_side(options, 20);
  if (!side.ok()) return side.error();
  const Result<PeerChoice> choice = choose_peers({"thesis", "layered", "bullet", "ode"}, options.engines);
  if (!choice.ok()) return choice.error();
  if (choice->peers.empty()) return bad_input("--engine: no engine is left to run");
  const golden::TemporaryFolder folder("tumble-bench");
  if (folder.path().empty()) return cannot_finish("no temporary folder for the logs");
  const AccuracySession session(*side, folder.path());
  Json results = {{"bench", "accuracy"}, {"machine", machine_json()}, {"scene", "grid_" + *side}};
  results["left_out"] = choice->left_out;
  results["engines"] = Json::array();
  if (!options.json) {
    std::cout
        << machine_text(results["machine"]) << "\ngrid_" << *side
        << " after 5 s; the limit of an engine is its run of dt 1/3000 with 8 substeps; "
        << "from the limit: mean distance of the cubes along y, in ascending order\n"
        << "guaranteed by construction: lateral and column spread of thesis and layered are 0; measured: all else\n";
  }
  FailedRuns failed(" of engines");
  std::vector<EngineAccuracy> engines;
  for (const Peer& peer : choice->peers) {
    engines.push_back({peer, peer.word, {}, ""});
    run_engine(session, options, engines.back());
    if (!engines.back().failure.empty())
      failed.add(engines.back().engine + " in grid_" + *side, engines.back().failure);
    if (!options.json) print(engines.back());
    results["engines"].push_back(to_json(engines.back()));
  }
  results["limits"] = limits_json(engines);
  if (!options.json && engines.size() > 1) {
    std::cout << "\ndistance between the limits of\n";
    Table table({"engine", "engine", ">distance"});
    for (const Json& row : results["limits"]) {
      const std::optional<double> apart = number_of(row["distance"]);
      table.add({row["engines"][0], row["engines"][1], apart ? fixed(*apart, 2) + " m" : "–"});
    }
    table.print();
  }
  if (Status ok = give_results(options, results); !ok.ok()) return ok.error();
  if (Status ok = failed.status(); !ok.ok()) return ok.error();
  return Exit::kSame;
}

}  // namespace tumble::tools
