// tumble bisect: the first difference of two logs, or the commit that changed a session.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "golden/bundle/file_hashes.h"
#include "src/files/output_guard.h"
#include "src/process/interrupt.h"
#include "src/process/split_words.h"
#include "tools/arguments/bisect_options.h"
#include "tools/arguments/command.h"
#include "tools/arguments/measure_arguments.h"
#include "tools/bisect/bisection.h"
#include "tools/bisect/engine_settings.h"
#include "tools/bisect/two_logs.h"
#include "tools/bisect/verdict.h"
#include "tools/files/log_files.h"
#include "tools/output/text.h"

namespace tumble::tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = "build/release/tools/tumble";
constexpr unsigned kProcessorsAJob = 8;
constexpr double kCacheGb = 5;

std::string absolute(const std::string& path) {
  std::error_code error;
  return path.empty() ? "" : fs::absolute(path, error).lexically_normal().string();
}

/// A build uses some processors by itself.
std::uint64_t usual_jobs() { return std::clamp(std::thread::hardware_concurrency() / kProcessorsAJob, 1U, 4U); }

/// The file of --scene, if it is given.
Status take_scene(const std::string& scene, bisect::Settings& settings) {
  if (scene.empty()) return {};
  if (settings.run.find("{scene}") == std::string::npos) {
    return bad_input("--scene: found no {scene} in the command that runs the engine, wanted one where the file is put");
  }
  settings.scene = absolute(scene);
  const Result<golden::FileHash> hash = golden::hash_file(settings.scene);
  if (!hash.ok()) return hash.error();
  settings.scene_hash = hash->hash;
  return {};
}

Result<bisect::Settings> settings_of(const BisectArguments& options) {
  if (Status ok = check_for_commits(options); !ok.ok()) return ok.error();
  bisect::Settings settings;
  settings.repository = absolute(options.repository.empty() ? "." : options.repository);
  settings.good = options.good;
  settings.bad = options.bad.empty() ? "HEAD" : options.bad;
  settings.asks = options.asks.value_or(settings.asks);
  settings.jobs = options.jobs.value_or(usual_jobs());
  settings.cache = absolute(options.cache);
  settings.cache_bytes = static_cast<std::uint64_t>(options.cache_gb.value_or(kCacheGb) * 1e9);
  settings.first_parent = options.first_parent;
  if (!options.logs.empty()) settings.log = absolute(options.logs[0]);
  if (!options.metric.empty()) {
    Result<replay::MetricBound> bound = replay::parse_metric_bound(options.metric);
    if (!bound.ok()) return bad_input("--metric: " + bound.error().message);
    settings.metric = *std::move(bound);
  }
  replay::EngineAxes axes;
  replay::BodyTable named;
  bool is_external = false;
  if (!options.logs.empty()) {
    Result<replay::LogReader> log = open_log(options.logs[0]);
    if (!log.ok()) return log.error();
    named = log->bodies();
    axes = log->header().axes();
    is_external = log->header().engine.has_value();
    const Result<golden::FileHash> hash = golden::hash_file(settings.log);
    if (!hash.ok()) return hash.error();
    settings.log_hash = hash->hash;
  }
  Result<replay::MeasureOptions> measure = parse_measure(options.measure, axes, named);
  if (!measure.ok()) return measure.error();
  settings.measure = *std::move(measure);
  settings.case_name = options.case_name;
  settings.image = options.image;
  settings.build = options.build;
  settings.program = options.program;
  settings.run = options.run;
  settings.timeout_s = options.timeout.value_or(0);
  if (settings.run.empty() && (is_external || !settings.case_name.empty())) {
    if (Status ok = bisect::take_project(settings.repository, settings); !ok.ok()) return ok.error();
    if (is_external && settings.run.empty()) {
      return bad_input(settings.log +
                       ": is of another engine, and there is no tumble.toml that says how it runs; write " +
                       "one (docs/other_engines.md), or give --run COMMAND");
    }
  }
  if (Status ok = take_scene(options.scene, settings); !ok.ok()) return ok.error();
  if (settings.program.empty()) settings.program = kProgram;
  if (settings.build.empty() && settings.run.empty() && !settings.has_project) {
    settings.build = {"cmake --preset release", "cmake --build --preset release --target tumble"};
  }
  if (!settings.cache.empty() && (!settings.run.empty() || settings.has_project)) {
    return bad_input(
        "--cache: keeps the program that a build makes, and the files of another engine's build are not "
        "known; leave it out");
  }
  for (const std::string& command : settings.build) {
    if (const auto words = process::split_words(command); !settings.shell && !words.ok())
      return bad_input("--build: " + words.error().message);
  }
  if (const auto words = process::split_words(settings.run); !settings.run.empty() && !settings.shell && !words.ok()) {
    return bad_input("--run: " + words.error().message);
  }
  return settings;
}

// Prints progress to stdout, or to stderr if stdout is to be one JSON value.
Result<bisect::Finding> search(const bisect::Settings& settings, const bisect::Workplace& place, bool json) {
  std::ostream& out = json ? std::cerr : std::cout;
  out << "question: " << printable(settings.question()) << "\nwork in:  " << place.root() << std::endl;
  const bisect::Git git(settings.repository, place.root());
  return bisect::find_commit(
      settings, place, git, [] { return process::InterruptGuard::interrupted(); },
      [&](const bisect::CommitFacts& facts) {
        out << "asking " << facts.shortly() << ' ' << printable(facts.subject) << std::endl;
      },
      [&](const bisect::Tested& tested, std::uint64_t left, unsigned steps) {
        out << tested_text(tested);
        if (left > 0) {
          out << "\n      " << count_text(left, "commit") << " left";
          if (steps > 0) out << ", about " << count_text(steps, "step");
        }
        out << std::endl;
      });
}

Result<Exit> find_commit(const BisectArguments& options) {
  const Result<bisect::Settings> settings = settings_of(options);
  if (!settings.ok()) return settings.error();
  const process::InterruptGuard guard;
  files::OutputGuard outputs;
  outputs.keep(settings->log, "the session to ask about");
  Result<bisect::Workplace> place =
      bisect::Workplace::open(absolute(options.work), settings->fingerprint(), options.resume, outputs);
  if (!place.ok()) return place.error();
  const Result<bisect::Finding> finding = search(*settings, *place, options.json);
  if (!finding.ok()) {
    if (!process::InterruptGuard::interrupted()) {
      if (options.keep || options.resume) return finding.error();
      std::error_code error;
      if (!std::filesystem::exists(place->state(), error)) return place->remove(), finding.error();  // nothing answered
      std::cerr << "tumble bisect: note: the clone and the answers stay in " << printable(place->root())
                << ", for --resume or to be deleted\n";
      return finding.error();
    }
    return cannot_finish(finding.error().message +
                         "; the answers are kept: repeat the command with --resume to continue");
  }
  const bisect::Comparison comparison = bisect::compare_sessions(*finding, *place);
  if (options.json) {
    print_json("bisect", bisect::verdict_json(*settings, *finding, comparison));
  } else {
    bisect::print_verdict(*settings, *finding, comparison);
  }
  if (!options.keep) place->remove();
  return finding->found() ? Exit::kDifference : Exit::kCannotFinish;
}

}  // namespace

Action declare_bisect(Arguments& arguments) {
  auto options = std::make_shared<BisectArguments>();
  declare_arguments(arguments, *options);
  return [options] {
    const bool logs_alone =
        options->good.empty() && options->bad.empty() && !options->automatic && options->logs.size() == 2;
    if (!logs_alone) return find_commit(*options);
    if (Status ok = check_for_logs(*options); !ok.ok()) return Result<Exit>(ok.error());
    return bisect::locate_in_logs(options->logs[0], options->logs[1], options->json, options->shared);
  };
}

}  // namespace tumble::tools
