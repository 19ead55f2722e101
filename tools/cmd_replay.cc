// tumble replay: a log through this build's physics, every step compared.
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "replay/log_reader.h"
#include "replay/replayer.h"
#include "tools/arguments.h"
#include "tools/command.h"
#include "tools/divergence_output.h"
#include "tools/interrupt.h"
#include "tools/log_files.h"
#include "tools/progress.h"
#include "tools/text.h"

namespace tumble::tools {
namespace {

struct Options {
  std::string log;
  std::optional<std::uint64_t> threads;
  bool json = false;
};

void print_text(const replay::ReplayReport& report, const replay::LogReader& log) {
  for (const std::string& note : report.notes) std::cout << "note: " << printable(note) << '\n';
  if (report.identical()) {
    std::cout << "identical: " << count_text(report.steps, "step") << " of " << printable(log.header().scene.name)
              << " replayed, every bit as recorded\nfinal hash  " << to_string(report.final_hash) << '\n';
    return;
  }
  std::cout << "different: the first of " << count_text(log.step_count(), "step") << " that differs is step "
            << report.first->step << '\n';
  print_divergence(*report.first);
}

Result<Exit> replay_command(const Options& options) {
  Result<replay::LogReader> log = open_log(options.log);
  if (!log.ok()) return log.error();
  ProgressBar bar("replaying");
  const InterruptGuard guard;
  const Result<replay::ReplayReport> report =
      replay::replay_log(*log, {}, [&](std::uint64_t done, std::uint64_t total) {
        bar.show(done, total);
        return !InterruptGuard::interrupted();
      });
  bar.finish();
  if (!report.ok()) return report.error();
  if (InterruptGuard::interrupted()) {
    return cannot_finish("interrupted; identical so far: " + count_text(report->steps, "step"));
  }
  if (options.json) {
    print_json(comparison_json(report->identical(), report->steps, report->first));
  } else {
    print_text(*report, *log);
  }
  return judge("replay", *log, report->identical() ? Exit::kSame : Exit::kDifference);
}

}  // namespace

Action declare_replay(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("LOG", options->log, "The log to replay")->required()->type_name("");
  add_threads(app, options->threads);
  add_json(app, options->json);
  app.footer(
      "Exit status: 0 identical, 1 a difference, 3 the log is damaged or torn (its whole part is replayed).\n\n"
      "Examples:\n"
      "  tumble replay brick_wall.tumble\n"
      "  tumble replay brick_wall.tumble --json");
  return [options] { return replay_command(*options); };
}

}  // namespace tumble::tools
