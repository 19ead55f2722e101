// tumble bench peers: scenes through our engine and the installed ones, in turn.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "golden/suite/temporary_folder.h"
#include "replay/format/not_finite.h"
#include "replay/measure/measure_log.h"
#include "tools/bench/bench.h"
#include "tools/bench/peer_programs.h"
#include "tumble/replay/log_reader.h"

namespace tumble::tools {
namespace {

namespace fs = std::filesystem;

/// A scene of bench/scenes and its overrides.
struct PeerScene {
  std::string name;
  std::string file;
  std::vector<std::string> overrides;
  bool large = false;
};

std::vector<PeerScene> peer_scenes() {
  std::vector<PeerScene> scenes;
  const std::string coarse = "world.dt=0.03333333333333333";
  for (const int n : {6, 10, 15, 20, 40, 60, 80}) {
    const std::string side = std::to_string(n);
    const std::vector<std::string> size = {"grid.rows=" + side, "grid.cols=" + side};
    scenes.push_back({"grid_" + side, "tilted_grid", size, n >= 40});
    scenes.push_back(
        {"grid_" + side + "_coarse", "tilted_grid", {size[0], size[1], coarse, "world.substeps=4"}, n >= 40});
  }
  for (const char* k : {"10", "20", "40"}) {
    const std::string count = std::string("tower.count=") + k;
    scenes.push_back({std::string("tower_") + k, "tower", {count}});
    scenes.push_back({std::string("tower_") + k + "_crooked",
                      "tower",
                      {count, "tower.jitter.position=0.01", "tower.jitter.degrees=2.0", "tower.jitter.seed=1"}});
  }
  scenes.push_back({"pyramid_20", "pyramid", {}});
  scenes.push_back({"pyramid_20_crooked",
                    "pyramid",
                    {"pyramid.jitter.position=0.01", "pyramid.jitter.degrees=2.0", "pyramid.jitter.seed=1"}});
  scenes.push_back({"brick_wall", "brick_wall", {}});
  scenes.push_back({"pile_8", "pile", {"pile.count=[8, 8, 8]"}});
  scenes.push_back({"pile_16", "pile", {}});
  scenes.push_back(
      {"pile_16_crooked", "pile", {"pile.jitter.position=0.01", "pile.jitter.degrees=2.0", "pile.jitter.seed=1"}});
  for (const char* name : {"large_pyramid", "many_pyramids", "tumbling_drum"}) scenes.push_back({name, name, {}, true});
  return scenes;
}

/// Ours with its default method first: the others' times are told in terms of it.
Result<PeerChoice> chosen_peers(const BenchOptions& options) {
  std::vector<std::string> asked = options.engines;
  if (!asked.empty()) asked.emplace_back("layered");
  return choose_peers({"layered", "thesis", "bullet", "ode", "mujoco"}, asked);
}

/// The result of one engine in one scene.
struct Score {
  std::string engine;  ///< "Bullet 3.24", "Tumble 0.1.0 thesis"; as the program is called where it failed
  std::string failure;
  std::vector<double> seconds;
  std::optional<replay::Metrics> metrics;
  std::optional<double> order_error;  ///< m, of a body between two orders of adding
};

class SceneRun {
 public:
  SceneRun(const PeerScene& scene, const sim::SceneDef& def, fs::path folder)
      : scene_(scene), folder_(std::move(folder)) {
    // States 30 to 60 times a second are enough for the metrics, and keep the logs of fine steps small.
    every_ = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::floor((1.0 / 30) / def.world.dt + 1e-6)));
  }

  /// One timed run. A failure is the engine's score in this scene.
  void time(const Peer& peer, Score& score) const {
    if (!score.failure.empty()) return;
    const Result<Json> line = run_for_json(command(peer), folder_);
    if (!line.ok()) {
      score.engine = peer.word;
      score.failure = line.error().message;
      return;
    }
    score.engine = (*line)["engine"];
    if (peer.is_ours()) score.engine += ' ' + peer.word;
    score.seconds.push_back((*line)["cpu_s"]);
  }

  /// Two runs for the log, with the bodies added in two orders. Errors: of the engine, whose score is a failure then.
  Status judge(const Peer& peer, Score& score) const {
    const std::string first = (folder_ / "first.tumble").string(), other = (folder_ / "shuffled.tumble").string();
    for (const std::string& path : {first, other}) {
      std::vector<std::string> words = command(peer);
      words.insert(words.end(), {"--every", std::to_string(every_), "--log", path});
      if (path == other) words.insert(words.end(), {"--shuffle", "1"});
      if (const Result<Json> line = run_for_json(std::move(words), folder_); !line.ok()) return line.error();
    }
    Result<replay::LogReader> log = replay::LogReader::open(first);
    if (!log.ok()) return log.error();
    Result<replay::LogReader> shuffled = replay::LogReader::open(other);
    if (!shuffled.ok()) return shuffled.error();
    const Result<replay::Metrics> metrics = replay::measure_log(*log);
    if (!metrics.ok()) return metrics.error();
    score.metrics = *metrics;
    const Result<const replay::StepRecord*> a = log->read_step(log->last_step());
    const Result<const replay::StepRecord*> b = shuffled->read_step(shuffled->last_step());
    if (!a.ok() || !b.ok()) return a.ok() ? b.error() : a.error();
    const replay::BodyStates &x = (*a)->states, &y = (*b)->states;
    double apart = 0;
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
      apart = replay::largest(apart, sim::length(sim::Vec3(x.position[i] - y.position[i])));
    }
    const bool comparable = x.id == y.id && replay::all_finite(x) && replay::all_finite(y);
    score.order_error = comparable ? apart : replay::kNotANumber;
    return {};
  }

 private:
  [[nodiscard]] std::vector<std::string> command(const Peer& peer) const {
    return peer_command(peer, bench_scene_path(scene_.file), scene_.overrides);
  }

  const PeerScene& scene_;
  fs::path folder_;
  std::uint64_t every_ = 1;
};

std::string metres(const std::optional<double>& value) { return value ? rounded(*value, "m") : "–"; }

void print(const PeerScene& scene, const sim::SceneDef& def, const std::vector<Score>& scores) {
  std::cout << '\n'
            << scene.name << ": " << count_text(def.boxes.size(), "body") << ", " << count_text(def.steps, "step")
            << " of " << rounded(def.world.dt, "s") << '\n';
  Table table({"engine", ">CPU s", ">× ours", ">lateral", ">column spread", ">order", ">overlap", ">in ground",
               ">drift", ">energy gain", ">lost"});
  for (const Score& score : scores) {
    if (!score.failure.empty()) {
      table.add({score.engine, "failed", "", "", "", "", "", "", "", "", ""});
      continue;
    }
    const replay::Metrics& m = *score.metrics;
    const double seconds = median(score.seconds);
    const bool known = scores.front().failure.empty();
    table.add({score.engine, short_number(seconds),
               known ? short_number(seconds / median(scores.front().seconds)) : "–", metres(m.symmetry.lateral_max),
               metres(m.symmetry.column_spread), metres(score.order_error), metres(m.stacking.overlap_max),
               metres(m.stacking.ground_penetration_max), metres(m.stacking.drift_max),
               m.energy.gain_ratio ? rounded(*m.energy.gain_ratio, "") : "–", std::to_string(m.stacking.lost)});
  }
  table.print();
  for (const Score& score : scores) {
    if (!score.failure.empty()) std::cout << score.engine << " failed: " << printable(score.failure) << '\n';
  }
  std::cout.flush();
}

Json to_json(const PeerScene& scene, const sim::SceneDef& def, const std::vector<Score>& scores) {
  Json out = {{"scene", scene.name}, {"bodies", def.boxes.size()}, {"steps", def.steps}, {"dt", def.world.dt}};
  out["engines"] = Json::array();
  const auto optional = [](const std::optional<double>& value) { return value ? number_json(*value) : Json(nullptr); };
  for (const Score& score : scores) {
    Json row = {{"engine", score.engine}, {"failure", score.failure}};
    if (score.failure.empty()) {
      const replay::Metrics& m = *score.metrics;
      row["cpu_s"] = median(score.seconds);
      row["cpu_s_runs"] = score.seconds;
      row["lateral_max"] = number_json(m.symmetry.lateral_max);
      row["column_spread"] = optional(m.symmetry.column_spread);
      row["order_error"] = optional(score.order_error);
      row["overlap_max"] = number_json(m.stacking.overlap_max);
      row["ground_penetration_max"] = number_json(m.stacking.ground_penetration_max);
      row["drift_max"] = number_json(m.stacking.drift_max);
      row["gain_ratio"] = optional(m.energy.gain_ratio);
      row["lost"] = m.stacking.lost;
    }
    out["engines"].push_back(std::move(row));
  }
  return out;
}

bool chosen(const PeerScene& scene, const BenchOptions& options) {
  if (options.scenes.empty()) return options.large || !scene.large;
  return std::ranges::any_of(options.scenes, [&](const std::string& name) { return scene.name.starts_with(name); });
}

Status check_scenes(const std::vector<PeerScene>& scenes, const BenchOptions& options) {
  for (const std::string& name : options.scenes) {
    if (std::ranges::none_of(scenes, [&](const PeerScene& scene) { return scene.name.starts_with(name); })) {
      return bad_input("--scene: found " + in_quotes(name) + ", and no scene of 'bench peers' begins so");
    }
  }
  return {};
}

}  // namespace

Result<Exit> bench_peers(const BenchOptions& options) {
  const std::vector<PeerScene> scenes = peer_scenes();
  if (Status ok = check_scenes(scenes, options); !ok.ok()) return ok.error();
  const Result<PeerChoice> choice = chosen_peers(options);
  if (!choice.ok()) return choice.error();
  const std::vector<Peer>& peers = choice->peers;
  if (peers.empty() || peers.front().word != "layered") {
    return cannot_finish("found no program " + build_folder() +
                         "/bench/peers/tumble_peer_tumble; build everything first");
  }
  const golden::TemporaryFolder folder("tumble-bench");
  if (folder.path().empty()) return cannot_finish("no temporary folder for the logs");
  Json results = {{"bench", "peers"}, {"machine", machine_json()}, {"repeat", options.repeat.value_or(5)}};
  results["left_out"] = choice->left_out;
  results["scenes"] = Json::array();
  if (!options.json) std::cout << machine_text(results["machine"]) << '\n';
  FailedRuns failed(" of engines");
  for (const PeerScene& scene : scenes) {
    if (!chosen(scene, options)) continue;
    const Result<sim::SceneDef> def = bench_scene(scene.file, scene.overrides);
    if (!def.ok()) return def.error();
    const SceneRun runs(scene, *def, folder.path());
    std::vector<Score> scores(peers.size());
    for (std::uint64_t r = 0; r < options.repeat.value_or(5); ++r) {
      for (std::size_t i = 0; i < peers.size(); ++i) runs.time(peers[i], scores[i]);
    }
    for (std::size_t i = 0; i < peers.size(); ++i) {
      Score& score = scores[i];
      Status judged = score.failure.empty() ? runs.judge(peers[i], score) : Status();
      if (!judged.ok()) score.failure = judged.error().message;
      if (!score.failure.empty()) failed.add(score.engine + " in " + scene.name, score.failure);
    }
    if (!options.json) print(scene, *def, scores);
    results["scenes"].push_back(to_json(scene, *def, scores));
  }
  if (Status ok = give_results(options, results); !ok.ok()) return ok.error();
  if (Status ok = failed.status(); !ok.ok()) return ok.error();
  return Exit::kSame;
}

}  // namespace tumble::tools
