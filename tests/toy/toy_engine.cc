// A small engine that is not Tumble: a stack of boxes along z with a friction spring along x, solved by sequential
// impulses. The tests of tumble.toml, of cases of another engine and of --zoom run it as a user's engine.
//
//   toy_engine --log FILE [--inputs FILE] [--scene FILE] [--push STEP:BODY:IMPULSE] [--gravity G] [--steps N]
//              [--fault N] [--jitter] [--reverse] [--table]
//
// --fault N: the N-th of ten lines computes another number, by a relative 1e-9. --jitter: a number of the clock moves
// the first body, as a race between threads would. --reverse: pairs are solved from the top. --table: the log is a
// table of comma-separated values.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "replay/probe/tumble_probe.h"
#include "tests/toy/toy_solver.h"
#include "tumble/replay/engine_log.h"

namespace tumble::toy {
namespace {

struct Options {
  std::string log, inputs, scene, push;
  std::uint64_t steps = 40;
  bool jitter = false, table = false;
  Solver solver;
};

struct Input {
  std::uint64_t step = 0;
  sim::Push push;
};

[[noreturn]] void stop(const std::string& message) {
  std::cerr << "toy_engine: " << message << '\n';
  std::exit(2);
}

Options read_options(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto take = [&]() -> std::string {
      if (i + 1 >= argc) stop(word + " wants a value");
      return argv[++i];
    };
    if (word == "--log")
      options.log = take();
    else if (word == "--inputs")
      options.inputs = take();
    else if (word == "--scene")
      options.scene = take();
    else if (word == "--push")
      options.push = take();
    else if (word == "--gravity")
      options.solver.gravity = std::stod(take());
    else if (word == "--steps")
      options.steps = std::stoul(take());
    else if (word == "--fault")
      options.solver.fault = std::stoi(take());
    else if (word == "--jitter")
      options.jitter = true;
    else if (word == "--reverse")
      options.solver.reverse = true;
    else if (word == "--table")
      options.table = true;
    else
      stop("unknown argument " + word);
  }
  if (options.log.empty()) stop("--log is missing");
  return options;
}

/// The pushes of --push and of a file {inputs}.
std::vector<Input> read_inputs(const Options& options) {
  std::vector<Input> inputs;
  if (!options.push.empty()) {
    Input input;
    char colon = 0;
    double impulse = 0;
    std::istringstream text(options.push);
    text >> input.step >> colon >> input.push.id >> colon >> impulse;
    input.push.impulse = {impulse, 0, 0};
    input.push.at_centre = true;
    inputs.push_back(input);
  }
  std::ifstream file(options.inputs);
  for (std::string line; std::getline(file, line);) {
    const nlohmann::json json = nlohmann::json::parse(line);
    if (json.value("kind", "") != "push") continue;
    const auto& impulse = json.at("impulse");
    Input input;
    input.step = json.at("step").get<std::uint64_t>();
    input.push.id = json.at("id").get<std::uint64_t>();
    input.push.impulse = {impulse[0].get<double>(), impulse[1].get<double>(), impulse[2].get<double>()};
    input.push.at_centre = true;
    inputs.push_back(input);
  }
  return inputs;
}

/// Heights of the boxes: a line a box, or three boxes where no scene is given.
std::vector<double> read_scene(const Options& options) {
  if (options.scene.empty()) return {0.5, 1.5, 2.5};
  std::ifstream file(options.scene);
  if (!file) stop(options.scene + ": cannot be read");
  std::vector<double> heights;
  for (double z = 0; file >> z;) heights.push_back(z);
  return heights;
}

sim::SceneDef start_of(const std::vector<Body>& bodies, const Options& options) {
  sim::SceneDef scene;
  scene.name = "toy";
  scene.world.dt = kDt;
  scene.world.gravity = {0, 0, -options.solver.gravity};
  scene.steps = options.steps;
  for (const Body& body : bodies) {
    sim::BoxDef box;
    box.id = body.id;
    box.position = {body.x, 0, body.z};
    scene.boxes.push_back(box);
  }
  return scene;
}

void write_row(std::ostream& table, std::uint64_t step, const Body& body) {
  table << step << ',' << body.id << ',' << body.x << ",0," << body.z << ",1,0,0,0," << body.vx << ",0," << body.vz
        << ",0,0,0\n";
}

/// The session as a table.
class Table {
 public:
  explicit Table(const std::string& path) : out_(path) {
    out_ << "# engine: toy\n# version: 1\n# dt: " << std::setprecision(17) << kDt
         << "\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z,"
            "velocity.x,velocity.y,velocity.z,spin.x,spin.y,spin.z\n";
  }
  void add(std::uint64_t step, const std::vector<Body>& bodies) {
    for (const Body& body : bodies) write_row(out_, step, body);
  }

 private:
  std::ofstream out_;
};

void check(const Status& status) {
  if (!status.ok()) stop(status.error().message);
}

int run(const Options& options) {
  if (tumble_probes_from_environment(&tumble_probes) != 0) stop("probes cannot be written");
  Solver solver = options.solver;
  const std::vector<double> heights = read_scene(options);
  for (std::size_t i = 0; i < heights.size(); ++i) solver.bodies.push_back({i + 1, 0, heights[i], 0, 0});
  const std::vector<Input> inputs = read_inputs(options);
  std::unique_ptr<Table> table;
  std::unique_ptr<replay::EngineLog> log;
  if (options.table) {
    table = std::make_unique<Table>(options.log);
    table->add(0, solver.bodies);
  } else {
    auto made = replay::EngineLog::create(options.log, {{"toy", "1"}}, start_of(solver.bodies, options));
    if (!made.ok()) stop(made.error().message);
    log = *std::move(made);
  }
  if (options.jitter) {
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    solver.bodies.front().x = 1e-6 * static_cast<double>(now % 1000);
  }
  for (std::uint64_t k = 1; k <= options.steps; ++k) {
    for (const Input& input : inputs) {
      if (input.step != k) continue;
      for (Body& body : solver.bodies) body.vx += body.id == input.push.id ? input.push.impulse.x() : 0;
      if (log) check(log->input(input.push));
    }
    solver.step(k);
    if (table) table->add(k, solver.bodies);
    if (!log) continue;
    for (const Body& body : solver.bodies) {
      replay::EngineState state;
      state.position = {body.x, 0, body.z};
      state.velocity = {body.vx, 0, body.vz};
      check(log->set_state(body.id, state));
    }
    check(log->end_step(kDt));
  }
  if (log) {
    const auto summary = log->finish();
    if (!summary.ok()) stop(summary.error().message);
  }
  return tumble_probes_close(&tumble_probes) == 0 ? 0 : 4;
}

}  // namespace
}  // namespace tumble::toy

int main(int argc, char** argv) { return tumble::toy::run(tumble::toy::read_options(argc, argv)); }
