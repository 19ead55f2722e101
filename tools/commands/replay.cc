// tumble replay: runs a log's inputs through this build's physics and compares every step.
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "replay/diff/difference_report.h"
#include "replay/log/checked_log.h"
#include "replay/probe/phase_probes.h"
#include "src/files/output_guard.h"
#include "src/process/interrupt.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/engine/replay_engine.h"
#include "tools/files/log_files.h"
#include "tools/output/difference_output.h"
#include "tools/output/divergence_output.h"
#include "tools/output/progress.h"
#include "tools/output/text.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/replayer.h"
#include "tumble/sim/limits.h"
#include "tumble/threads/worker_threads.h"

namespace tumble::tools {
namespace {

struct ReplayCommand {
  std::string log;
  std::optional<std::uint64_t> threads;
  EngineReplay engine;
  std::string probes;  // file for the probes of a step
  std::optional<std::uint64_t> probe_step;
  bool brief = false;
  bool json = false;
};

// Explains the first difference, as far as it can be found out.
replay::DifferenceReport look_closer(replay::LogReader& log, const replay::Divergence& first) {
  Result<replay::LogReader> again = open_log(log.name());
  ProgressBar bar("looking closer");
  return replay::report_replay_difference(log, again.ok() ? &*again : nullptr, first, bar.progress());
}

void print_text(const replay::ReplayReport& report, const replay::LogReader& log,
                const std::optional<replay::DifferenceReport>& difference) {
  for (const std::string& note : report.notes) std::cout << "note: " << printable(note) << '\n';
  if (report.identical() && report.steps == 0) {
    std::cout << "nothing was replayed: the log has no step; the world made of its scene is as recorded\n";
    print_scope(report.scope);
    return;
  }
  if (report.identical()) {
    std::cout << "identical: " << count_text(report.steps, "step") << " of " << printable(log.header().scene.name)
              << " replayed, " << report.scope.every_bit() << " as recorded\nfinal hash  "
              << to_string(report.final_hash) << '\n';
    print_scope(report.scope);
    return;
  }
  std::cout << "different: the first of " << count_text(log.step_count(), "step") << " that differs is step "
            << report.first->step << '\n';
  const Sides sides = {printable(std::filesystem::path(log.name()).filename().string()), "this build"};
  if (difference) {
    print_difference(*difference, Compared::kReplay, sides);
  } else {
    print_divergence(*report.first, sides);
    print_scope(report.scope);
  }
}

// Damage goes before a difference, and a replay stops at the first one: the rest of the log is read here.
Status check_rest(replay::LogReader& log) {
  ProgressBar bar("reading the rest");
  const Result<replay::VerifyReport> checked = replay::check_log(log, bar.progress());
  return checked.ok() ? Status() : Status(checked.error());
}

/// The probes of one step alone: what `diff --zoom` asks of each of two builds.
Result<Exit> write_probes(const ReplayCommand& options, replay::LogReader& log) {
  files::OutputGuard guard;
  guard.keep(options.log, "the log");
  if (Status ok = claim_output(guard, "--probes", options.probes, files::FileKind::kProbes); !ok.ok())
    return ok.error();
  if (Status ok = replay::write_phase_probes(log, *options.probe_step, options.probes); !ok.ok()) return ok.error();
  return judge("replay", log, Exit::kSame);
}

Result<Exit> replay_command(const ReplayCommand& options) {
  Result<replay::LogReader> log = open_log(options.log);
  if (!log.ok()) return log.error();
  if (log->header().engine) {
    if (options.probe_step) {
      return bad_input("--probes: " + log->name() +
                       " is of another engine, which writes its probes itself: see "
                       "'tumble diff --zoom'");
    }
    EngineReplay how = options.engine;
    how.brief = options.brief;
    how.json = options.json;
    return replay_engine(*log, how);
  }
  if (options.probe_step) return write_probes(options, *log);
  if (!options.engine.scene.empty() || !options.engine.output.empty() || options.engine.no_build ||
      options.engine.stop || options.engine.timeout_s) {
    return bad_input("--scene, -o, --no-build, --stop and --timeout: are for a log of another engine; " + log->name() +
                     " is of Tumble's own physics");
  }
  ProgressBar bar("replaying");
  const process::InterruptGuard guard;
  const std::unique_ptr<WorkerThreads> threads = worker_threads(options.threads.value_or(1));
  replay::ReplayOptions how;
  how.workers = threads.get();
  Result<replay::ReplayReport> report = replay::replay_log(*log, how, bar.progress());
  bar.finish();
  if (!report.ok()) return report.error();
  std::optional<replay::DifferenceReport> difference;
  if (report->first && options.brief) {
    report->scope.not_compared.push_back("all behind step " + std::to_string(report->first->step) +
                                         ": not read, so damage there is not seen");
  }
  if (report->first && !options.brief) {
    if (Status ok = check_rest(*log); !ok.ok()) return ok.error();
    difference = look_closer(*log, *report->first);
    report->first = difference->first;
  }
  if (options.json) {
    Json json = comparison_json(report->identical(), report->steps, report->first);
    json["notes"] = report->notes;
    add_scope(report->scope, json);
    if (difference) add_difference(*difference, Compared::kReplay, json);
    print_json("replay", json);
  } else {
    print_text(*report, *log, difference);
  }
  return judge("replay", *log, report->identical() ? Exit::kSame : Exit::kDifference);
}

}  // namespace

Action declare_replay(Arguments& arguments) {
  auto options = std::make_shared<ReplayCommand>();
  arguments.positional("LOG", options->log, "The log to replay").required();
  arguments.threads(options->threads);
  arguments.flag("--brief", options->brief,
                 "Stop at the first difference: do not follow its growth, and do not read the rest of the log");
  arguments.option("--scene", "FILE", options->engine.scene,
                   "Another engine's log: the scene for {scene} of tumble.toml, instead of the log's text of one");
  arguments.option("-o,--output", "LOG", options->engine.output,
                   "Another engine's log: keep the session that the engine computes now");
  arguments.flag("--no-build", options->engine.no_build,
                 "Another engine's log: run the engine as it is, without the build commands of tumble.toml");
  arguments.flag("--stop", options->engine.stop,
                 "Another engine's log: end the engine at the first difference, which is found while it runs");
  constexpr double kTimeMax = 1e9;
  arguments.positive("--timeout", "S", options->engine.timeout_s, kTimeMax,
                     "Another engine's log: end an engine that runs longer than S seconds; if not given, the timeout "
                     "of tumble.toml");
  const Argument probes = arguments.option(
      "--probes", "FILE", options->probes,
      "Instead: write the probes of step --probe-step to this file, as 'tumble diff --zoom' asks of two builds");
  const Argument step = arguments.whole("--probe-step", "K", options->probe_step, 1, sim::kStepsMax, "See --probes");
  probes.needs(step);
  step.needs(probes);
  arguments.json(options->json);
  arguments.footer(
      "A log of another engine is replayed by that engine: the nearest tumble.toml, from this folder upwards, says "
      "how\n"
      "it is built and run (docs/other_engines.md).\n\n"
      "Exit status: 0 identical, 1 a difference, 3 the log is damaged or torn (its whole part is replayed).\n\n"
      "Examples:\n"
      "  tumble replay brick_wall.tumble\n"
      "  tumble replay brick_wall.tumble --json");
  return [options] { return replay_command(*options); };
}

}  // namespace tumble::tools
