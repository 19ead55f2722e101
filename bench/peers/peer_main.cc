// One program an engine: runs a scene through it, times the steps and prints the time as a line of JSON.
// Run by hand; docs/other_engines.md shows how.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <ctime>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/peers/engine.h"
#include "src/base/rng.h"
#include "tumble/replay/engine_log.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::peers {
namespace {

struct Options {
  std::string scene;
  std::vector<std::string> overrides;
  std::optional<std::uint64_t> shuffle;
  std::string log;
  std::uint64_t every = 1;  // steps of the engine that make one of the log
};

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Result<sim::SceneDef> read_scene(const Options& options) {
  std::ifstream file(options.scene, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) return bad_input(options.scene + ": cannot be read");
  return scenes::parse_scene(text, options.scene, options.overrides);
}

/// The order in which bodies are added: the scene's, or a shuffled one.
std::vector<std::size_t> order_of(std::size_t count, const std::optional<std::uint64_t>& seed) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (seed) std::ranges::sort(order, {}, [&](std::size_t i) { return random_bits(*seed, i, 0); });
  return order;
}

/// A session of one engine: the bodies in the order in which they were added, and the log if one is wanted.
class Session {
 public:
  Session(const sim::SceneDef& scene, const Options& options)
      : scene_(scene),
        options_(options),
        engine_(make_engine(scene)),
        next_(scene.inputs.begin()),
        dt_(scene.world.dt) {}

  /// CPU seconds of all steps; the clock is not read between steps unless there is something else to do: a step of
  /// a few bodies takes less time than reading the clock.
  Result<double> run() {
    if (Status ok = start(); !ok.ok()) return ok.error();
    double seconds = 0;
    for (std::uint64_t k = 1; k <= scene_.steps;) {
      if (k > 1) {
        if (Status ok = apply_inputs(k); !ok.ok()) return ok.error();
      }
      const std::uint64_t next = next_stop(k);
      const double before = cpu_seconds();
      for (; k < next; ++k, since_log_ += dt_) {
        if (Status ok = engine_->step(dt_); !ok.ok()) return ok.error();
      }
      seconds += cpu_seconds() - before;
      if (Status ok = write_step(next - 1); !ok.ok()) return ok.error();
    }
    if (!log_) return seconds;
    const Result<replay::LogSummary> summary = log_->finish();
    if (!summary.ok()) return summary.error();
    return seconds;
  }

 private:
  /// Bodies of the start and those thrown in before the first step. Some engines accept bodies only here.
  Status start() {
    for (const std::size_t i : order_of(scene_.boxes.size(), options_.shuffle)) {
      if (Status ok = add(scene_.boxes[i]); !ok.ok()) return ok;
    }
    if (!options_.log.empty()) {
      sim::SceneDef start = scene_;
      start.inputs.clear();
      Result<std::unique_ptr<replay::EngineLog>> log = replay::EngineLog::create(options_.log, {engine_name()}, start);
      if (!log.ok()) return log.error();
      log_ = *std::move(log);
    }
    if (Status ok = apply_inputs(1); !ok.ok()) return ok;
    return engine_->ready();
  }

  Status add(const sim::BoxDef& box) {
    ids_.push_back(box.id);
    return engine_->add(box);
  }

  /// The inputs that any engine understands.
  Status apply_inputs(std::uint64_t k) {
    for (; next_ != scene_.inputs.end() && next_->step == k; ++next_) {
      Status done;
      if (const auto* thrown = std::get_if<sim::Throw>(&next_->command)) {
        done = add(thrown->box);
      } else if (const auto* length = std::get_if<sim::SetDt>(&next_->command)) {
        dt_ = length->dt;
      } else if (const auto* pull = std::get_if<sim::SetGravity>(&next_->command)) {
        done = engine_->set_gravity(pull->gravity);
      } else {
        done = bad_input("step " + std::to_string(k) + ": found input \"" + sim::name_of(next_->command) +
                         "\", wanted throw, set_dt or set_gravity, which every engine can do");
      }
      if (done.ok() && log_) done = log_->input(next_->command);
      if (!done.ok()) return done;
    }
    return {};
  }

  /// The first step from k + 1 on that needs something done before it.
  [[nodiscard]] std::uint64_t next_stop(std::uint64_t k) const {
    if (log_) return k + 1;
    const std::uint64_t end = scene_.steps + 1;
    return next_ == scene_.inputs.end() ? end : std::clamp(next_->step, k + 1, end);
  }

  Status write_step(std::uint64_t k) {
    if (!log_ || (k % options_.every != 0 && k != scene_.steps)) return {};
    for (std::size_t row = 0; row < ids_.size(); ++row) {
      const BodyState body = engine_->read(row);
      const replay::EngineState state = {body.position, body.orientation, body.velocity, body.spin, body.sleeping};
      if (Status ok = log_->set_state(ids_[row], state); !ok.ok()) return ok;
    }
    return log_->end_step(std::exchange(since_log_, 0));
  }

  const sim::SceneDef& scene_;
  const Options& options_;
  std::unique_ptr<Engine> engine_;
  std::vector<sim::TimedCommand>::const_iterator next_;  // input
  double dt_;
  double since_log_ = 0;          // s
  std::vector<sim::BodyId> ids_;  // in the order of adding
  std::unique_ptr<replay::EngineLog> log_;
};

int fail(const Error& error) {
  std::cerr << to_string(engine_name()) << ": " << error.message << '\n';
  return error.kind == ErrorKind::kBadInput ? 2 : 4;
}

int main_with(const Options& options) {
  const Result<sim::SceneDef> scene = read_scene(options);
  if (!scene.ok()) return fail(scene.error());
  const Result<double> seconds = Session(*scene, options).run();
  if (!seconds.ok()) return fail(seconds.error());
  const nlohmann::ordered_json line = {{"engine", to_string(engine_name())},
                                       {"scene", scene->name},
                                       {"bodies", scene->boxes.size()},
                                       {"steps", scene->steps},
                                       {"cpu_s", *seconds}};
  std::cout << line.dump() << '\n';
  return 0;
}

}  // namespace
}  // namespace tumble::peers

int main(int argc, char** argv) {
  CLI::App app("Runs a scene through " + to_string(tumble::peers::engine_name()));
  tumble::peers::Options options;
  app.add_option("SCENE", options.scene, "The scene file")->required();
  app.add_option("--set", options.overrides, "Overrides a value of the scene")->allow_extra_args(false);
  app.add_option("--shuffle", options.shuffle, "Adds the bodies in another order: the seed of it");
  app.add_option("--log", options.log, "Writes a log of all states, not timed");
  app.add_option("--every", options.every, "Steps of the engine that make one of the log")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  return tumble::peers::main_with(options);
}
