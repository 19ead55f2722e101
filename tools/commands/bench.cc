// tumble bench: speed, comparison with other engines, growth.
#include "tools/bench/bench.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "golden/suite/temporary_folder.h"
#include "src/base/text.h"
#include "src/files/output_guard.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/files/log_files.h"
#include "tools/files/scene_files.h"
#include "tools/output/gnuplot.h"
#include "tools/view/view_bench.h"

namespace tumble::tools {
namespace {

/// An option, and the benchmarks that take it.
struct BenchOption {
  const char* name;
  bool is_given;
  std::vector<std::string_view> belongs_to;
};

/// An option that would be passed over changes nothing, which its user does not know.
Status check_belonging(const BenchOptions& options) {
  const std::vector<std::string_view> own = {"peers",  "table1", "accuracy", "scaling",
                                             "memory", "live",   "view",     "export"};
  const std::vector<BenchOption> all = {
      {"--repeat", options.repeat.has_value(), {"peers", "table1", "scaling", "export"}},
      {"--budget", options.budget.has_value(), {"table1", "accuracy", "scaling", "live"}},
      {"--scene", !options.scenes.empty(), {"peers", "memory", "accuracy", "view", "export", "threads"}},
      {"--engine", !options.engines.empty(), {"peers", "table1", "accuracy"}},
      {"--measure", options.measure, {"threads"}},
      {"--large", options.large, {"peers"}},
      {"--method", !options.method.empty(), {"table1", "scaling", "memory"}},
      {"--plot", !options.plot.empty(), {"scaling"}},
      {"--save", !options.save.empty(), own},
      {"--json", options.json, own}};
  for (const BenchOption& option : all) {
    if (!option.is_given || std::ranges::find(option.belongs_to, options.what) != option.belongs_to.end()) continue;
    std::string names;
    for (const std::string_view name : option.belongs_to) names += (names.empty() ? "" : ", ") + std::string(name);
    return bad_input(std::string(option.name) + ": found with bench " + options.what +
                     ", which has no use for it; wanted with " + names);
  }
  return {};
}

/// A benchmark by its name.
struct Benchmark {
  std::string_view name;
  Result<Exit> (*run)(const BenchOptions& options);
  bool has_files = false;  // of its own, in the place for temporary ones
};

Result<Exit> bench_threads(const BenchOptions& options) {
  std::vector<std::string> words = options.scenes;
  if (options.measure) words.emplace_back("--measure");
  return bench_program("thread_model", words);
}

constexpr std::array kBenchmarks = {
    Benchmark{"peers", bench_peers, true},
    Benchmark{"table1", bench_table1, true},
    Benchmark{"accuracy", bench_accuracy, true},
    Benchmark{"scaling", bench_scaling},
    Benchmark{"memory", bench_memory},
    Benchmark{"live", bench_live, true},
    Benchmark{"view", bench_view, true},
    Benchmark{"export", bench_export, true},
    Benchmark{"phases", [](const BenchOptions&) { return bench_program("step_bench", {}); }},
    Benchmark{"threads", bench_threads},
    Benchmark{"record", [](const BenchOptions&) { return bench_program("log_bench", {}); }},
    Benchmark{"render",
              [](const BenchOptions&) {
                return bench_program("render_bench", {"brick_wall.tumble", "60", "640", "480", "1"});
              }},
};

std::vector<std::string_view> benchmark_names() {
  std::vector<std::string_view> names;
  names.reserve(kBenchmarks.size());
  for (const Benchmark& benchmark : kBenchmarks) names.push_back(benchmark.name);
  return names;
}

Result<Exit> bench(const BenchOptions& options) {
  if (Status ok = check_belonging(options); !ok.ok()) return ok.error();
  if (!options.method.empty() && options.method != "thesis" && options.method != "layered") {
    return bad_input("--method: found " + in_quotes(options.method) + ", wanted thesis or layered");
  }
  files::OutputGuard guard;
  for (const std::string& scene : options.scenes) {
    const Result<SceneFile> file = find_scene(scene);
    guard.keep(file.ok() ? file->path : bench_scene_path(scene), "a scene that is read");
  }
  if (!options.plot.empty()) {
    if (Status ok = check_plot_path(options.plot); !ok.ok()) return ok.error();
    if (Status ok = claim_output(guard, "--plot", options.plot, files::kind_by_name(options.plot)); !ok.ok())
      return ok.error();
  }
  if (!options.save.empty()) {
    if (Status ok = claim_output(guard, "--save", options.save, files::FileKind::kJson); !ok.ok()) return ok.error();
  }
  const auto* const found = std::ranges::find(kBenchmarks, options.what, &Benchmark::name);  // Arguments took no other
  if (found->has_files) {
    if (const Status ok = golden::check_temporary_place(); !ok.ok()) return ok.error();
  }
  return found->run(options);
}

}  // namespace

Action declare_bench(Arguments& arguments) {
  auto options = std::make_shared<BenchOptions>();
  arguments.positional("WHAT", options->what, benchmark_names()).required();
  arguments.whole("--repeat", "N", options->repeat, 1, 1000, "Runs of which the median counts (peers: 5, others: 1)");
  arguments.positive(
      "--budget", "S", options->budget, 1e6,
      "CPU seconds to spend; runs beyond it are left out. scaling: 300; table1, accuracy: of each engine (all runs); "
      "live: on the wall, of each scene (10)");
  arguments.option("--scene", "NAME", options->scenes,
                   "peers: only scenes whose name begins so; memory: SCENE; accuracy: grid_N (grid_20); view, "
                   "export: grid_N (grid_80); threads: 6400, 25600, "
                   "102400, pile, large_pyramid; may be repeated");
  arguments
      .option("--engine", "NAME", options->engines,
              "peers: only thesis, bullet, ode, mujoco or none beside ours; table1: these beside ours; accuracy: only "
              "thesis, "
              "layered, bullet or ode; may be repeated. Without it, engines that are not built are left out, and said")
      .offers({"thesis", "layered", "bullet", "ode", "mujoco", "none"});
  arguments.flag("--measure", options->measure,
                 "threads: measure two threads beside two copies of the program side by side");
  arguments.flag("--large", options->large, "peers: also the scenes of 1600 bodies and more");
  arguments
      .option("--method", "NAME", options->method,
              "table1 (thesis), scaling (layered), memory (the scene's): another method")
      .offers({"layered", "thesis"});
  arguments.option("--plot", "FILE.svg|png", options->plot, "scaling: also draw it, with gnuplot");
  arguments.option("--save", "FILE.json", options->save,
                   "Also write the results and the machine to this file, as JSON");
  arguments.json(options->json);
  arguments.footer(
      "peers    our scenes through both our methods, Bullet, ODE and MuJoCo, where they are installed, in turn\n"
      "table1   our times of the thesis's Table I beside its own and Havok's\n"
      "accuracy the distance of the rows of cubes from each engine's converged solution\n"
      "scaling  the exponent of time over the number of bodies\n"
      "memory   the simulation's bytes by body and by contact\n"
      "live     frames a second of the window of 'tumble live', played without a person; needs a display, or xvfb-run\n"
      "view     waiting times of the served page of 6400 cubes in 1500 steps, and the memory of its server\n"
      "export   seconds, memory and MB/s of raw states that 'tumble export' takes for 6400 cubes in 1500 steps\n"
      "phases, threads, record, render   the programs step_bench, thread_model, log_bench and render_bench (of "
      "brick_wall.tumble) of the build\n\n"
      "Times are CPU seconds of one thread, but for live, view and export. docs/performance.md explains the "
      "figures.\n\n"
      "Examples:\n"
      "  tumble bench peers --scene grid_20 --scene tower\n"
      "  tumble bench threads --measure --scene large_pyramid\n"
      "  tumble bench table1 --budget 60 --engine bullet\n"
      "  tumble bench accuracy --engine thesis --save accuracy.json\n"
      "  tumble bench view --save view.json\n"
      "  tumble bench scaling --plot scaling.svg --save scaling.json");
  return [options] { return bench(*options); };
}

}  // namespace tumble::tools
