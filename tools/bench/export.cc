// tumble bench export: how fast a session is written in the formats of other programs.
#include <array>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "tools/bench/bench.h"
#include "tools/bench/peer_programs.h"
#include "tools/bench/workplace.h"

namespace tumble::tools {
namespace {

constexpr unsigned kSide = 80;  // of the square of cubes
constexpr std::uint64_t kSteps = 1500;
constexpr double kStateBytes = 13 * 8;  // position, orientation, velocity and angular velocity
constexpr double kMegabyte = 1e6;
constexpr double kMemoryMost = 300;  // MB

struct Wanted {
  const char* format;
  double megabytes_per_second;  ///< of raw state; 0: no figure is wanted
};
constexpr std::array<Wanted, 3> kWanted = {{{"npz", 200}, {"mcap", 50}, {"glb", 50}}};

/// Cubes that all move apart: a log whose columns repeat would be read and packed sooner.
std::vector<std::string> recording(const std::string& side, const std::string& log) {
  std::vector<std::string> words = {
      "record", bench_scene_path("tilted_grid"), "--steps", std::to_string(kSteps), "--quiet", "-o", log};
  for (const std::string& value : {"rows=" + side, "cols=" + side, std::string("jitter.position=0.01"),
                                   std::string("jitter.degrees=2"), std::string("jitter.seed=1")}) {
    words.insert(words.end(), {"--set", "grid." + value});
  }
  return words;
}

double bytes_of(const std::string& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  return error ? 0 : static_cast<double>(size);
}

/// The run of `repeat` that took the median time.
Result<ProgramRun> median_run(const Workplace& place, const std::vector<std::string>& words, std::uint64_t repeat) {
  std::vector<ProgramRun> runs;
  for (std::uint64_t i = 0; i < repeat; ++i) {
    Result<ProgramRun> run = place.run(words);
    if (!run.ok() || run->exit != 0) return run;
    runs.push_back(*std::move(run));
  }
  std::ranges::sort(runs, {}, &ProgramRun::seconds);
  return runs[runs.size() / 2];
}

std::string why(const ProgramRun& run) {
  if (run.exit < 0) return "a signal ended it";
  const std::string said = run.err.substr(0, run.err.find_last_not_of('\n') + 1);
  return "ended with status " + std::to_string(run.exit) + (said.empty() ? "" : ": " + said);
}

Result<Json> measure(const BenchOptions& options, const std::string& side, FailedRuns& failed) {
  const Workplace place;
  const std::string log = place.file("grid.tumble");
  const Result<ProgramRun> recorded = place.run(recording(side, log));
  if (!recorded.ok()) return recorded.error();
  if (recorded->exit != 0) return cannot_finish("export: recording the session " + why(*recorded));
  const double bodies = std::stod(side) * std::stod(side);
  const double raw = bodies * static_cast<double>(kSteps + 1) * kStateBytes / kMegabyte;
  Json rows = Json::array();
  for (const auto& [format, wanted] : kWanted) {
    const std::string file = place.file(std::string("grid.") + format);
    const Result<ProgramRun> run = median_run(place, {"export", log, "-o", file}, options.repeat.value_or(1));
    if (!run.ok()) return run.error();
    if (run->exit == 2) {  // a build without that format
      rows.push_back({{"format", format}, {"left_out", run->err}});
      continue;
    }
    if (run->exit != 0) {
      failed.add(format, why(*run));
      continue;
    }
    rows.push_back({{"format", format},
                    {"seconds", run->seconds},
                    {"cpu", run->cpu},
                    {"megabytes_per_second", raw / run->seconds},
                    {"wanted", wanted},
                    {"megabytes", run->megabytes},
                    {"bytes", bytes_of(file)}});
    std::filesystem::remove(file);
  }
  return Json{
      {"bodies", bodies}, {"steps", kSteps}, {"raw_megabytes", raw}, {"log_bytes", bytes_of(log)}, {"rows", rows}};
}

void print(const Json& found) {
  std::cout << found["bodies"].get<double>() << " bodies, " << found["steps"]
            << " steps: " << short_number(found["raw_megabytes"]) << " MB of raw states, a log of "
            << bytes_text(found["log_bytes"].get<std::uint64_t>()) << '\n';
  Table table({"format", ">seconds", ">CPU s", ">raw MB/s", ">wanted", ">memory MB", ">wanted", ">file MB", "met"});
  for (const Json& row : found["rows"]) {
    if (row.contains("left_out")) {
      std::cout << row["format"].get<std::string>() << ": left out: " << row["left_out"].get<std::string>();
      continue;
    }
    const double speed = row["megabytes_per_second"], wanted = row["wanted"], memory = row["megabytes"];
    table.add({"." + row["format"].get<std::string>(), short_number(row["seconds"]), short_number(row["cpu"]),
               short_number(speed), short_number(wanted), short_number(memory), short_number(kMemoryMost),
               short_number(row["bytes"].get<double>() / kMegabyte),
               speed >= wanted && memory <= kMemoryMost ? "yes" : "no"});
  }
  table.print();
}

}  // namespace

Result<Exit> bench_export(const BenchOptions& options) {
  const Result<std::string> side = grid_side(options, kSide);
  if (!side.ok()) return side.error();
  FailedRuns failed;
  const Result<Json> found = measure(options, *side, failed);
  if (!found.ok()) return found.error();
  Json results = {{"bench", "export"}, {"machine", machine_json()}};
  results.update(*found);
  results["failures"] = failed.json();
  if (Status ok = give_results(options, results); !ok.ok()) return ok.error();
  if (!options.json) {
    std::cout << machine_text(results["machine"]) << '\n';
    print(results);
    failed.print();
  }
  if (Status ok = failed.status(); !ok.ok()) return ok.error();
  return Exit::kSame;
}

}  // namespace tumble::tools
