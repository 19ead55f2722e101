#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/output/exit.h"
#include "tools/output/text.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

/// Shared by the parts of `tumble bench`. docs/performance.md explains the figures.
namespace tumble::tools {

struct BenchOptions {
  std::string what;
  std::optional<std::uint64_t> repeat;  ///< runs of which the median counts
  std::optional<double> budget;         ///< s of CPU, table1, accuracy: of each engine; runs beyond it are left out
  std::vector<std::string>
      scenes;  ///< peers: only scenes whose name begins so; memory: these; accuracy, view, export: the grid
  std::vector<std::string> engines;  ///< peers, accuracy: only these; table1: these besides ours
  bool measure = false;              ///< threads: measure two threads instead of estimating more
  bool large = false;                ///< peers: scenes of 1600 bodies and more too
  std::string method;  ///< table1, scaling, memory; empty: table1 thesis, scaling layered, memory the scene's
  std::string plot;    ///< scaling: FILE.svg or FILE.png
  std::string save;    ///< also write the results, with the machine, to this file as JSON
  bool json = false;
};

Result<Exit> bench_peers(const BenchOptions& options);
Result<Exit> bench_table1(const BenchOptions& options);
Result<Exit> bench_accuracy(const BenchOptions& options);
Result<Exit> bench_scaling(const BenchOptions& options);
Result<Exit> bench_memory(const BenchOptions& options);
Result<Exit> bench_export(const BenchOptions& options);
Result<Exit> bench_live(const BenchOptions& options);

/// Runs one of the programs of bench/ beside this one, with its output as it is.
Result<Exit> bench_program(const std::string& name, const std::vector<std::string>& arguments);

/// The build folder of this program, which has the programs of bench/.
std::string build_folder();

/// The scene bench/scenes/<name>.toml of data_folder().
std::string bench_scene_path(const std::string& name);
Result<sim::SceneDef> bench_scene(const std::string& name, const std::vector<std::string>& overrides);

/// N of the one "grid_N" that --scene may name: N rows of N cubes. usual: N where there is no --scene. Errors
/// (kBadInput): any other scene.
Result<std::string> grid_side(const BenchOptions& options, unsigned usual);

/// Processor, cores, load, kernel, compiler, flags, version of the tool and the day.
Json machine_json();
std::string machine_text(const Json& machine);

/// Prints `results` as JSON for --json, and writes them to the file of --save.
Status give_results(const BenchOptions& options, const Json& results);

/// CPU seconds of this process so far.
double cpu_seconds();

double median(std::vector<double> values);

/// "0.0123", "41.9": three digits, no exponent; "inf" and the like of what is no finite number.
std::string short_number(double value);

/// The text of a file that a program printed to; empty where it cannot be read.
std::string printed_in(const std::string& path);

}  // namespace tumble::tools
