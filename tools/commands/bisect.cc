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

#include "src/files/output_guard.h"
#include "src/process/interrupt.h"
#include "src/process/split_words.h"
#include "tools/arguments/arguments.h"
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

struct BisectCommand {
  std::vector<std::string> logs;
  std::string good, bad;
  std::string repository = ".";
  bool first_parent = false;
  std::string metric;
  MeasureArguments measure;
  std::string case_name;
  bool image = false;
  std::vector<std::string> build;
  std::string program;
  std::string run;
  std::optional<double> timeout;
  std::string work;
  bool resume = false;
  bool keep = false;
  bool automatic = false;
  std::optional<std::uint64_t> asks, jobs;
  std::string cache;
  std::optional<double> cache_gb;
  bool shared = false;
  bool json = false;
};

std::string absolute(const std::string& path) {
  std::error_code error;
  return path.empty() ? "" : fs::absolute(path, error).lexically_normal().string();
}

Status check_arguments(const BisectCommand& options) {
  const bool of_commits = !options.good.empty() || options.automatic;
  if (!of_commits && options.logs.size() > 2) {
    return bad_input("wanted two logs to compare, found " + std::to_string(options.logs.size()));
  }
  if (!of_commits) {
    return bad_input(
        "wanted two logs, or --good REV and --bad REV, or --auto\n'tumble bisect --help' explains the arguments.");
  }
  if (options.logs.size() > 1) {
    return bad_input("wanted one log with --good and --bad or --auto, found " + std::to_string(options.logs.size()));
  }
  if (options.logs.empty() == options.case_name.empty()) {
    return bad_input("wanted LOG, the session to ask about, or --case NAME in its place");
  }
  if (options.image && options.case_name.empty()) {
    return bad_input("--image: wanted --case NAME too, the case whose pictures are judged");
  }
  if (!options.metric.empty() && !options.case_name.empty()) return bad_input("--metric: does not go with --case");
  if (!options.run.empty() && !options.case_name.empty()) return bad_input("--run: does not go with --case");
  if (!options.run.empty() && options.run.find("{log}") == std::string::npos) {
    return bad_input("--run: wanted {log} in the command line, where the log to write is put");
  }
  return {};
}

/// A build uses some processors by itself.
std::uint64_t usual_jobs() { return std::clamp(std::thread::hardware_concurrency() / kProcessorsAJob, 1U, 4U); }

Result<bisect::Settings> settings_of(const BisectCommand& options) {
  if (Status ok = check_arguments(options); !ok.ok()) return ok.error();
  bisect::Settings settings;
  settings.repository = absolute(options.repository);
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
  if (settings.program.empty()) settings.program = kProgram;
  if (settings.build.empty() && settings.run.empty() && !settings.has_project) {
    settings.build = {"cmake --preset release", "cmake --build --preset release --target tumble"};
  }
  if (!settings.cache.empty() && !settings.run.empty()) {
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

Result<Exit> find_commit(const BisectCommand& options) {
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

void declare_question(Arguments& arguments, BisectCommand& options) {
  arguments
      .option("--metric", "EXPR", options.metric,
              "Ask whether the session, recorded anew by each revision, is within a bound, as in 'lateral_max<=0'")
      .offers(metric_words());
  add_measure(arguments, options.measure);
  arguments.option("--case", "NAME", options.case_name,
                   "Ask whether each revision's own check of this golden case passes");
  arguments.flag("--image", options.image, "With --case: ask for the image verdict alone");
}

void declare_building(Arguments& arguments, BisectCommand& options) {
  arguments.option("--repo", "DIR", options.repository, "A folder in the clone; the current one if not given");
  arguments.flag("--first-parent", options.first_parent, "Follow first parents only, to find a merge");
  arguments.option(
      "--build", "COMMAND", options.build,
      "A command that builds a revision, run in its folder; may be repeated. If not given: none with --run, else the "
      "release preset's build of tumble; of another engine's session, that of tumble.toml");
  arguments.option(
      "--program", "PATH", options.program,
      "The program that the build makes, a path from that folder; build/release/tools/tumble if not given");
  arguments.option(
      "--run", "COMMAND", options.run,
      "Instead of the program and of tumble.toml: a command of any engine that makes the log {log} of the scene "
      "{scene} and the inputs {inputs}");
  constexpr double kTimeoutMax = 1e6;
  arguments.positive("--timeout", "S", options.timeout, kTimeoutMax, "Skip a revision whose program takes longer");
  arguments.option("--work", "DIR", options.work,
                   "Work in this folder; one under the folder for temporary files if not given");
  arguments.whole("--jobs", "N", options.jobs, 1, 64,
                  "Revisions built and asked at once; one for every eight processors if not given, at most four");
  arguments.whole("--asks", "N", options.asks, 1, 100,
                  "Ask each revision N times, and more often if its answers differ; 2 if not given");
  const Argument cache = arguments.option("--cache", "DIR", options.cache, "Keep the built programs in this folder");
  arguments.positive("--cache-size", "GB", options.cache_gb, 1e6, "Its bound; 5 if not given").needs(cache);
  arguments.flag("--resume", options.resume, "Continue an interrupted bisection: its arguments and --resume");
  arguments.flag("--keep", options.keep, "Keep the folder with the clone, the last build and the sessions");
}

}  // namespace

Action declare_bisect(Arguments& arguments) {
  auto options = std::make_shared<BisectCommand>();
  arguments.positionals("LOG", options->logs, "Two logs; or, with --good and --bad, the session to ask about");
  const Argument good = arguments.option("--good", "REV", options->good, "A good revision");
  const Argument bad = arguments.option("--bad", "REV", options->bad, "A later, bad revision");
  good.needs(bad);
  arguments
      .flag("--auto", options->automatic,
            "Find the good revision too: back from the bad one, or from HEAD, by 1, 2, 4 … first parents")
      .excludes(good);
  arguments
      .flag("--shared", options->shared,
            "Two logs: judge only what both have; a channel that one log alone has is named, and no difference")
      .excludes(good);
  declare_question(arguments, *options);
  declare_building(arguments, *options);
  arguments.json(options->json);
  arguments.footer(
      "docs/bisecting.md explains it. Revisions that do not build or cannot read the log are skipped. The clone's own\n"
      "files, index and branches are not touched.\n\n"
      "Exit status: 0 two logs are identical; 1 they differ, or the commit was found; 2 bad usage, or both revisions\n"
      "answer alike; 3 a damaged log; 4 interrupted, or the remaining commits could not be asked.\n\n"
      "Examples:\n"
      "  tumble bisect before.tumble after.tumble\n"
      "  tumble bisect --good v0.1 --bad main wall.tumble\n"
      "  tumble bisect --auto wall.tumble --cache ~/.cache/tumble-builds --jobs 2\n"
      "  tumble bisect --good HEAD~40 --bad HEAD grid.tumble --metric 'lateral_max<=0'\n"
      "  tumble bisect --good HEAD~40 --bad HEAD --case brick_wall --image");
  return [options] {
    const bool logs_alone =
        options->good.empty() && options->bad.empty() && !options->automatic && options->logs.size() == 2;
    return logs_alone ? bisect::locate_in_logs(options->logs[0], options->logs[1], options->json, options->shared)
                      : find_commit(*options);
  };
}

}  // namespace tumble::tools
