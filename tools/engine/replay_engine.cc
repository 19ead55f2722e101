#include "tools/engine/replay_engine.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "golden/suite/temporary_folder.h"
#include "replay/diff/difference_report.h"
#include "src/files/output_guard.h"
#include "src/process/interrupt.h"
#include "tools/engine/engine_session.h"
#include "tools/files/log_files.h"
#include "tools/output/difference_output.h"
#include "tools/output/divergence_output.h"
#include "tools/output/progress.h"
#include "tools/output/text.h"
#include "tumble/replay/compare.h"

namespace tumble::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kWarningsShown = 5;

void print_text(const replay::DiffReport& report, const std::optional<replay::DifferenceReport>& difference,
                const replay::LogReader& log, const replay::LogReader& again, bool brief) {
  for (const replay::HeaderDifference& header : report.headers) {
    std::cout << "header: " << printable(describe(header)) << '\n';
  }
  for (const std::string& note : report.notes) std::cout << "note: " << printable(note) << '\n';
  const std::string engine = printable(to_string(*again.header().engine));
  if (report.identical()) {
    std::cout << "same: " << count_text(report.steps, "step") << " computed again by " << engine
              << " with the log's inputs, every compared bit as recorded";
    if (report.zeros > 0) std::cout << ", but for the sign of " << count_text(report.zeros, "zero");
    std::cout << '\n';
    if (const std::string though = report.though(); !though.empty()) std::cout << "  " << though << '\n';
    print_scope(report.scope);
    return;
  }
  const Sides sides = {printable(fs::path(log.name()).filename().string()), "this run"};
  if (!report.first) {
    std::cout << "different in length: the log ends with step " << report.last_a << ", this run with step "
              << report.last_b << "; the " << count_text(report.steps, "step") << " of both are the same\n";
    print_scope(report.scope);
    return;
  }
  std::cout << "different: the first of " << count_text(log.step_count(), "step") << " that differs is step "
            << report.first->step << '\n';
  if (difference && !brief) {
    print_difference(*difference, Compared::kTwoLogs, sides);
  } else {
    std::cout << "cause   " << printable(replay::cause_of(report, *report.first)) << '\n';
    print_divergence(*report.first, sides);
  }
}

Json json_of(const replay::DiffReport& report, const std::optional<replay::DifferenceReport>& difference,
             const EngineSession& session, const replay::LogReader& again) {
  Json json = comparison_json(report.identical(), report.steps, report.first);
  json["engine"] = to_string(*again.header().engine);
  json["command"] = session.command;
  json["last_steps"] = {report.last_a, report.last_b};
  json["notes"] = report.notes;
  json["headers"] = Json::array();
  for (const replay::HeaderDifference& header : report.headers) json["headers"].push_back(describe(header));
  add_scope(report.scope, json);
  if (difference) add_difference(*difference, Compared::kTwoLogs, json);
  return json;
}

Status keep(const std::string& from, const std::string& to) {
  std::error_code error;
  fs::copy_file(from, to, fs::copy_options::overwrite_existing, error);
  return error ? Status(cannot_finish(to + ": cannot be written: " + error.message())) : Status();
}

}  // namespace

Result<Exit> replay_engine(replay::LogReader& log, const EngineReplay& options) {
  const Result<golden::EngineProject> project = project_for(log);
  if (!project.ok()) return project.error();
  files::OutputGuard guard;
  guard.keep(log.name(), "the log");
  guard.keep(options.scene, "the scene");
  if (!options.output.empty()) {
    if (Status ok = guard.claim("-o", options.output); !ok.ok()) return ok.error();
  }
  const golden::TemporaryFolder folder("tumble-replay");
  if (folder.path().empty()) return cannot_finish("no temporary folder for the engine's session");
  const process::InterruptGuard interrupts;
  const EngineSessionOptions how = {options.scene, options.no_build, {}};
  Result<EngineSession> session = run_engine_session(log, *project, how, folder.path());
  if (!session.ok()) return session.error();
  for (std::size_t i = 0; i < std::min(kWarningsShown, session->warnings.size()); ++i) {
    std::cerr << "tumble replay: warning: " << printable(session->warnings[i]) << '\n';
  }
  if (!options.output.empty()) {
    if (Status ok = keep(session->log, options.output); !ok.ok()) return ok.error();
  }
  Result<replay::LogReader> again = open_log(session->log);
  if (!again.ok()) return again.error();
  if (!again->header().engine) {
    return bad_input(project->file.string() + ": run wrote a log of Tumble's own physics, wanted one of " +
                     to_string(*log.header().engine));
  }
  ProgressBar bar("comparing");
  Result<replay::DiffReport> report = replay::diff_logs(log, *again, {}, bar.progress());
  bar.finish();
  if (!report.ok()) return report.error();
  std::optional<replay::DifferenceReport> difference;
  if (report->first && !options.brief) {
    Result<replay::DifferenceReport> found = replay::report_difference(log, *again, *report);
    if (!found.ok()) return found.error();
    difference = *std::move(found);
    report->first = difference->first;
  }
  if (options.json) {
    print_json(json_of(*report, difference, *session, *again));
  } else {
    print_text(*report, difference, log, *again, options.brief);
  }
  return judge("replay", log, judge("replay", *again, report->identical() ? Exit::kSame : Exit::kDifference));
}

}  // namespace tumble::tools
