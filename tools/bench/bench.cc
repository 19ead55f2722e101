#include "tools/bench/bench.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "golden/suite/text_files.h"
#include "src/base/check.h"
#include "src/base/text.h"
#include "src/files/output_file.h"
#include "src/process/run_child.h"
#include "tools/files/data_folder.h"
#include "tools/files/scene_files.h"
#include "tumble/replay/step_record.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::tools {
namespace {

namespace fs = std::filesystem;

/// The value of the first line "key : value" in a file of /proc.
std::string proc_value(const char* path, const std::string& key) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with(key) && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  std::array<char, 20> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts);
  return text.data();
}

}  // namespace

std::string build_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return program.parent_path().parent_path().string();
}

std::string bench_scene_path(const std::string& name) {
  return (data_folder() / "bench" / "scenes" / (name + ".toml")).string();
}

Result<sim::SceneDef> bench_scene(const std::string& name, const std::vector<std::string>& overrides) {
  const std::string path = bench_scene_path(name);
  const Result<std::string> text = read_scene(path);
  if (!text.ok()) return text.error();
  return scenes::parse_scene(*text, path, overrides);
}

Result<std::string> grid_side(const BenchOptions& options, unsigned usual) {
  const std::string name = options.scenes.empty() ? "grid_" + std::to_string(usual) : options.scenes.front();
  const std::string side = name.starts_with("grid_") ? name.substr(5) : "";
  const bool is_number = !side.empty() && side.size() < 4 && side.find_first_not_of("0123456789") == std::string::npos;
  if (options.scenes.size() > 1 || !is_number || side.front() == '0') {
    return bad_input("--scene: found " + in_quotes(name) + ", wanted one grid_N, say grid_" + std::to_string(usual));
  }
  return side;
}

Result<Exit> bench_program(const std::string& name, const std::vector<std::string>& arguments) {
  const std::string path = build_folder() + "/bench/" + name;
  std::error_code error;
  if (!fs::exists(path, error)) {
    return cannot_finish(path + ": not built; cmake --build --preset release --target " + name);
  }
  process::Program program;
  program.words = {path};
  program.words.insert(program.words.end(), arguments.begin(), arguments.end());
  program.own_group = false;  // Ctrl-C ends both
  std::cout.flush();
  const Result<process::ChildEnd> end = process::run_child(program);
  if (!end.ok()) return end.error();
  if (!end->well()) return cannot_finish(name + ' ' + end->text() + "; its message is above");
  return Exit::kSame;
}

Json machine_json() {
  utsname kernel{};
  ::uname(&kernel);
  double load = 0;
  std::ifstream("/proc/loadavg") >> load;
  const replay::LogHeader header = replay::header_for({});
  return {{"processor", proc_value("/proc/cpuinfo", "model name")},
          {"cores", std::thread::hardware_concurrency()},
          {"load_average", load},
          {"system", std::string(kernel.sysname) + ' ' + kernel.release + ' ' + kernel.machine},
          {"compiler", header.tool_build},
          {"flags", TUMBLE_BUILD_FLAGS},
          {"tool_version", header.tool_version},
          {"date", today()}};
}

std::string machine_text(const Json& machine) {
  return machine["processor"].get<std::string>() + ", " + std::to_string(machine["cores"].get<unsigned>()) +
         " cores, load " + exact(machine["load_average"].get<double>()) + "; " +
         machine["compiler"].get<std::string>() + ' ' + machine["flags"].get<std::string>();
}

Status give_results(const BenchOptions& options, const Json& results) {
  if (options.json) print_json("bench", results);
  if (options.save.empty()) return {};
  return files::write_whole_file(options.save, results.dump(1) + '\n');
}

double cpu_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  SIM_CHECK(!values.empty());
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

std::string short_number(double value) {
  if (value == 0) return "0";
  if (!std::isfinite(value)) return exact(value);
  const int before = static_cast<int>(std::floor(std::log10(std::fabs(value)))) + 1;
  return fixed(value, std::clamp(3 - before, 0, 9));
}

std::string printed_in(const std::string& path) {
  Result<std::string> text = golden::read_text(path);
  return text.ok() ? *std::move(text) : std::string();
}

}  // namespace tumble::tools
