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
#include "src/process/interrupt.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/files/log_files.h"
#include "tools/output/difference_output.h"
#include "tools/output/divergence_output.h"
#include "tools/output/progress.h"
#include "tools/output/text.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/replayer.h"
#include "tumble/threads/worker_threads.h"

namespace tumble::tools {
namespace {

struct ReplayCommand {
  std::string log;
  std::optional<std::uint64_t> threads;
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
  if (report.identical()) {
    std::cout << "identical: " << count_text(report.steps, "step") << " of " << printable(log.header().scene.name)
              << " replayed, every bit as recorded\nfinal hash  " << to_string(report.final_hash) << '\n';
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

Result<Exit> replay_command(const ReplayCommand& options) {
  Result<replay::LogReader> log = open_log(options.log);
  if (!log.ok()) return log.error();
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
    print_json(json);
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
  arguments.json(options->json);
  arguments.footer(
      "Exit status: 0 identical, 1 a difference, 3 the log is damaged or torn (its whole part is replayed).\n\n"
      "Examples:\n"
      "  tumble replay brick_wall.tumble\n"
      "  tumble replay brick_wall.tumble --json");
  return [options] { return replay_command(*options); };
}

}  // namespace tumble::tools
