// tumble bench live: frames a second of the window, simulation included.
#include <array>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "golden/suite/temporary_folder.h"
#include "src/process/run_child.h"
#include "tools/bench/bench.h"
#include "tools/bench/peer_programs.h"
#include "tools/files/helper_program.h"

namespace tumble::tools {
namespace {

struct LiveScene {
  const char* name;
  const char* size;
  double goal;  // frames a second, on two idle cores without a graphics card
  std::vector<const char*> words;
};

const std::array<LiveScene, 2>& live_scenes() {
  static const std::array<LiveScene, 2> kScenes = {
      {{"brick_wall", "640x480", 30, {"brick_wall"}},
       {"6400 cubes",
        "320x240",
        15,
        {"tilted_grid", "--set", "grid.rows=80", "--set", "grid.cols=80", "--set", "world.dt=0.0166666666666666"}}}};
  return kScenes;
}
constexpr double kSecondsEach = 10;
constexpr std::uint64_t kInputFramesMost = 2;

Result<Json> measure(const std::string& helper, const LiveScene& scene, double seconds) {
  const golden::TemporaryFolder folder("tumble_bench_live");
  const auto file = [&](const char* name) { return (folder.path() / name).string(); };
  process::Program program;
  program.words = {helper,   "--json",   "--measure", short_number(seconds),
                   "--size", scene.size, "-o",        file("played.tumble")};
  program.words.insert(program.words.end(), scene.words.begin(), scene.words.end());
  program.out = file("out");
  program.err = file("err");
  const Result<process::ChildEnd> end = process::run_child(program, seconds * 10 + 120);
  if (!end.ok()) return end.error();
  std::string complaint = printed_in(program.err);
  while (complaint.ends_with('\n')) complaint.pop_back();
  if (!end->well()) return cannot_finish("the window " + end->text() + (complaint.empty() ? "" : ": " + complaint));
  Json json = Json::parse(printed_in(program.out), nullptr, false);
  if (json.is_discarded() || !json.contains("measured")) return cannot_finish("the window reported no figures");
  Json row = json["measured"];
  row["scene"] = scene.name;
  row["size"] = scene.size;
  row["goal"] = scene.goal;
  row["driver"] = json["driver"];
  return row;
}

bool is_met(const Json& row) {
  return row["frames_per_second"].get<double>() >= row["goal"].get<double>() &&
         row["input_frames"]["most"].get<std::uint64_t>() <= kInputFramesMost;
}

std::string ms(const Json& seconds) { return short_number(seconds.get<double>() * 1e3); }

void print(const Json& results, const FailedRuns& failed) {
  std::cout << machine_text(results["machine"]) << '\n';
  Table table({"scene", "size", "frames/s", "goal", "frame ms", "p95", "draw ms", "step ms", "steps/s", "sim s/s",
               "input frames", "met"});
  for (const Json& row : results["rows"]) {
    table.add({row["scene"], row["size"], short_number(row["frames_per_second"]), short_number(row["goal"]),
               ms(row["frame_seconds"]["mean"]), ms(row["frame_seconds"]["p95"]), ms(row["draw_seconds"]["mean"]),
               ms(row["step_seconds"]["mean"]), short_number(row["steps_per_second"]),
               short_number(row["simulated_per_second"]),
               short_number(row["input_frames"]["mean"]) + ", at most " + row["input_frames"]["most"].dump(),
               is_met(row) ? "yes" : "no"});
  }
  if (!results["rows"].empty()) table.print();
  if (!results["rows"].empty()) {
    std::cout << "drawn with " << printable(results["rows"][0]["driver"].get<std::string>()) << '\n';
  }
  failed.print();
}

}  // namespace

Result<Exit> bench_live(const BenchOptions& options) {
  const std::string helper = helper_program("tumble-live");
  if (helper.empty()) {
    return cannot_finish("live: this build has no window; install libglfw3-dev and libimgui-dev and build again");
  }
  Json results;
  results["machine"] = machine_json();
  results["rows"] = Json::array();
  FailedRuns failed;
  for (const LiveScene& scene : live_scenes()) {
    const Result<Json> row = measure(helper, scene, options.budget.value_or(kSecondsEach));
    if (row.ok()) results["rows"].push_back(*row);
    if (!row.ok()) failed.add(scene.name, row.error().message);
  }
  results["failures"] = failed.json();
  if (Status ok = give_results(options, results); !ok.ok()) return ok.error();
  if (!options.json) print(results, failed);
  if (Status ok = failed.status(); !ok.ok()) return ok.error();
  return Exit::kSame;
}

}  // namespace tumble::tools
