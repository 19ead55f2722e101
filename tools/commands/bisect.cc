// tumble bisect: the first difference of two logs, or the commit that changed a session.
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "replay/diff/difference_report.h"
#include "replay/diff/locate_divergence.h"
#include "src/files/output_guard.h"
#include "src/process/interrupt.h"
#include "src/process/split_words.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/arguments/measure_arguments.h"
#include "tools/bisect/bisection.h"
#include "tools/bisect/engine_settings.h"
#include "tools/bisect/verdict.h"
#include "tools/files/log_files.h"
#include "tools/output/difference_output.h"
#include "tools/output/divergence_output.h"
#include "tools/output/text.h"

namespace tumble::tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = "build/release/tools/tumble";

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
  bool json = false;
};

// --- two logs ---

Result<Exit> locate_in_logs(const BisectCommand& options) {
  Result<replay::LogReader> a = open_log(options.logs[0]);
  if (!a.ok()) return a.error();
  Result<replay::LogReader> b = open_log(options.logs[1]);
  if (!b.ok()) return b.error();
  const process::InterruptGuard guard;
  const Result<replay::LocatedDivergence> located = replay::diff_and_locate(
      *a, *b, [](std::uint64_t, std::uint64_t) { return !process::InterruptGuard::interrupted(); });
  if (!located.ok()) return located.error();
  if (process::InterruptGuard::interrupted()) return cannot_finish("interrupted");
  const replay::DiffReport& report = located->report;
  const std::size_t chunks = a->chunks().size() + b->chunks().size();
  const auto judge_both = [&] {
    return judge("bisect", *b, judge("bisect", *a, report.identical() ? Exit::kSame : Exit::kDifference));
  };
  if (options.json) {
    Json json = comparison_json(report.identical(), report.steps, report.first);
    json["read"] = read_of(*a, *b);
    add_scope(report.scope, json);
    json["notes"] = report.notes;
    json["cause"] = report.first ? Json(replay::cause_of(report, *report.first)) : Json(nullptr);
    json["narrowed"] = report.first ? location_json(located->location) : Json(nullptr);
    json["chunks_opened"] = located->chunks_opened;
    json["chunks"] = chunks;
    print_json("bisect", json);
    return judge_both();
  }
  for (const std::string& note : report.notes) std::cout << "note: " << printable(note) << '\n';
  if (report.first) {
    std::cout << "different from step " << report.first->step << " on\n";
    std::cout << "cause   " << printable(replay::cause_of(report, *report.first)) << '\n';
    const Sides sides = sides_of(options.logs[0], options.logs[1]);
    print_divergence(*report.first, sides);
    print_location(located->location, sides);
    std::cout << "  opened      " << located->chunks_opened << " chunks of " << chunks << '\n';
  } else {
    std::cout << (report.identical() ? "identical: " : "different in length; identical: ")
              << count_text(report.steps, "step") << '\n';
    if (const std::string though = report.though(); !though.empty()) std::cout << "  " << though << '\n';
    print_scope(report.scope);
  }
  return judge_both();
}

// --- commits ---

std::string absolute(const std::string& path) {
  std::error_code error;
  return path.empty() ? "" : fs::absolute(path, error).lexically_normal().string();
}

Status check_arguments(const BisectCommand& options) {
  if (options.good.empty() && options.logs.size() > 2) {
    return bad_input("wanted two logs to compare, found " + std::to_string(options.logs.size()));
  }
  if (options.good.empty() || options.bad.empty()) {
    return bad_input("wanted two logs, or --good REV and --bad REV\n'tumble bisect --help' explains the arguments.");
  }
  if (options.logs.size() > 1) {
    return bad_input("wanted one log with --good and --bad, found " + std::to_string(options.logs.size()));
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

Result<bisect::Settings> settings_of(const BisectCommand& options) {
  if (Status ok = check_arguments(options); !ok.ok()) return ok.error();
  bisect::Settings settings;
  settings.repository = absolute(options.repository);
  settings.good = options.good;
  settings.bad = options.bad;
  settings.first_parent = options.first_parent;
  if (!options.logs.empty()) settings.log = absolute(options.logs[0]);
  if (!options.metric.empty()) {
    Result<replay::MetricBound> bound = replay::parse_metric_bound(options.metric);
    if (!bound.ok()) return bad_input("--metric: " + bound.error().message);
    settings.metric = *std::move(bound);
  }
  replay::EngineAxes axes;
  bool is_external = false;
  if (!options.logs.empty()) {
    const Result<replay::LogReader> log = open_log(options.logs[0]);
    if (!log.ok()) return log.error();
    axes = log->header().axes();
    is_external = log->header().engine.has_value();
  }
  Result<replay::MeasureOptions> measure = parse_measure(options.measure, axes);
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
        out << tested_text(tested) << "\n      " << count_text(left, "commit") << " left, about "
            << count_text(steps, "step") << std::endl;
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
    if (!process::InterruptGuard::interrupted()) return finding.error();
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
  arguments.option(
      "--metric", "EXPR", options.metric,
      "Ask whether the session, recorded anew by each revision, is within a bound, as in 'lateral_max<=0'");
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
  bad.needs(good);
  declare_question(arguments, *options);
  declare_building(arguments, *options);
  arguments.json(options->json);
  arguments.footer(
      "docs/bisecting.md explains it. Revisions that do not build or cannot read the log are skipped. The clone's own\n"
      "files, index and branches are not touched.\n\n"
      "Exit status: 0 two logs are identical, 1 they differ, or the commit was found, 4 interrupted, or the\n"
      "remaining commits could not be asked.\n\n"
      "Examples:\n"
      "  tumble bisect before.tumble after.tumble\n"
      "  tumble bisect --good v0.1 --bad main wall.tumble\n"
      "  tumble bisect --good HEAD~40 --bad HEAD grid.tumble --metric 'lateral_max<=0'\n"
      "  tumble bisect --good HEAD~40 --bad HEAD --case brick_wall --image");
  return [options] {
    const bool logs_alone = options->good.empty() && options->logs.size() == 2;
    return logs_alone ? locate_in_logs(*options) : find_commit(*options);
  };
}

}  // namespace tumble::tools
