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
#include "src/files/output_file.h"
#include "src/files/output_guard.h"
#include "src/process/interrupt.h"
#include "tools/engine/engine_session.h"
#include "tools/files/log_files.h"
#include "tools/output/difference_output.h"
#include "tools/output/divergence_output.h"
#include "tools/output/progress.h"
#include "tools/output/text.h"
#include "tumble/replay/byte_io.h"
#include "tumble/replay/compare.h"

namespace tumble::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kWarningsShown = 5;

void print_text(const replay::DiffReport& report, const std::optional<replay::DifferenceReport>& difference,
                const replay::LogReader& log, const replay::LogReader& again, const EngineReplay& options,
                bool gets_inputs) {
  for (const replay::HeaderDifference& header : report.headers) {
    std::cout << "header: " << printable(describe(header)) << '\n';
  }
  for (const std::string& note : report.notes) std::cout << "note: " << printable(note) << '\n';
  const std::string engine = printable(to_string(*again.header().engine));
  const Sides sides = {printable(fs::path(log.name()).filename().string()), "this run"};
  const std::string only_in = report.only_in.text("the log", sides.actual);
  if (report.computed_again()) {
    std::cout << "same: " << count_text(report.steps, "step") << " computed again by " << engine
              << (gets_inputs ? " with the log's inputs" : "; its run has no {inputs}, so it got none of the log's")
              << ", every compared bit as recorded";
    if (report.zeros > 0) std::cout << ", but for the sign of " << count_text(report.zeros, "zero");
    std::cout << '\n';
    if (!only_in.empty()) std::cout << "  " << printable(only_in) << ", which the log cannot judge\n";
    if (const std::string though = report.though(); !though.empty()) std::cout << "  " << though << '\n';
    print_scope(report.scope);
    return;
  }
  if (!report.first && report.last_a == report.last_b) {
    std::cout << "different in what was recorded: " << printable(only_in) << "; the "
              << count_text(report.steps, "step") << " of both are the same in all else that was compared\n";
    print_scope(report.scope);
    return;
  }
  if (!report.first) {
    std::cout << "different in length: the log ends with step " << report.last_a << ", this run with step "
              << report.last_b << "; the " << count_text(report.steps, "step") << " of both are the same\n";
    print_scope(report.scope);
    return;
  }
  std::cout << "different: the first of " << count_text(log.step_count(), "step") << " that differs is step "
            << report.first->step << '\n';
  if (difference && !options.brief) {
    print_difference(*difference, Compared::kTwoLogs, sides);
  } else {
    std::cout << "cause   " << printable(replay::cause_of(report, *report.first)) << '\n';
    print_divergence(*report.first, sides);
  }
}

Json json_of(const replay::DiffReport& report, const std::optional<replay::DifferenceReport>& difference,
             const EngineSession& session, const replay::LogReader& again) {
  Json json = comparison_json(report.computed_again(), report.steps, report.first);
  json["only_in"] = only_in_json(report.only_in);
  json["engine"] = to_string(*again.header().engine);
  json["command"] = session.command;
  json["engine_ended"] = session.stopped ? "stopped" : session.failure.empty() ? "well" : "failed";
  json["engine_failure"] = session.stopped ? "" : session.failure;
  json["last_steps"] = {report.last_a, report.last_b};
  json["notes"] = report.notes;
  json["headers"] = Json::array();
  for (const replay::HeaderDifference& header : report.headers) json["headers"].push_back(describe(header));
  add_scope(report.scope, json);
  if (difference) add_difference(*difference, Compared::kTwoLogs, json);
  return json;
}

/// A temporary file's name tells a user nothing.
void name_this_run(const std::string& path, std::vector<std::string>& texts) {
  for (std::string& text : texts) {
    for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path, at)) {
      text.replace(at, path.size(), "this run");
    }
  }
}

/// Compares the steps that both have, and answers.
Result<Exit> compare_with(replay::LogReader& log, replay::LogReader& again, const EngineSession& session,
                          const EngineReplay& options) {
  const bool ended = session.failure.empty();
  const std::uint64_t until = ended ? replay::kNoLimit : std::min(log.last_step(), again.last_step());
  ProgressBar bar("comparing");
  Result<replay::DiffReport> report = replay::diff_logs(log, again, {}, bar.progress(), replay::Reading::kAll, until);
  bar.finish();
  if (!report.ok()) return report.error();
  // A session that was cut short, or whose engine left early, has planned its own length in no other way.
  if (!ended || again.last_step() < log.last_step())
    std::erase_if(report->headers, [](const auto& header) { return header.key == "planned steps"; });
  if (!ended && !report->first) {
    return cannot_finish(session.failure + "; the " + count_text(report->steps, "step") +
                         " that it wrote before, up to step " + std::to_string(until) + " of " +
                         std::to_string(log.last_step()) + ", are the same as the log's");
  }
  for (std::vector<std::string>* texts : {&report->notes, &report->scope.compared, &report->scope.not_compared}) {
    name_this_run(again.name(), *texts);
  }
  for (const std::string& end : {session.failure, session.unfinished}) {
    if (end.empty()) continue;
    report->notes.push_back((session.stopped ? "the engine was " : "the engine did not end well: ") + end);
  }
  std::optional<replay::DifferenceReport> difference;
  if (report->first && !options.brief) {
    Result<replay::DifferenceReport> found = replay::report_difference(log, again, *report);
    if (!found.ok()) return found.error();
    difference = *std::move(found);
    report->first = difference->first;
    name_bodies(log, again, difference->first);
    if (difference->effect) name_bodies(log, again, *difference->effect);
  }
  if (report->first) name_bodies(log, again, *report->first);
  replay::name_by_own_axes(log.header(), again.header(), *report, difference ? &*difference : nullptr);
  if (options.json) {
    print_json("replay", json_of(*report, difference, session, again));
  } else {
    print_text(*report, difference, log, again, options, session.gets_inputs);
  }
  const Exit verdict = report->computed_again() ? Exit::kSame : Exit::kDifference;
  return judge("replay", log, ended ? judge("replay", again, verdict) : verdict);
}

Status keep(const std::string& from, const std::string& to) {
  Result<files::OutputFile> file = files::OutputFile::create(to);
  if (!file.ok()) return file.error();
  if (file->is_device()) return bad_input("-o: " + to + ": found a device or a pipe, wanted a file");
  std::error_code error;
  fs::copy_file(from, file->part(), fs::copy_options::overwrite_existing, error);
  return error ? Status(cannot_finish(to + ": cannot be written: " + error.message())) : file->commit();
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
    if (Status ok = replay::may_replace(options.output); !ok.ok()) return ok.error();
  }
  const golden::TemporaryFolder folder("tumble-replay");
  if (folder.path().empty()) return cannot_finish("no temporary folder for the engine's session");
  const process::InterruptGuard interrupts;
  SessionWatch watch(log, options.stop);
  const EngineSessionOptions how = {options.scene, options.no_build, {}, options.timeout_s.value_or(0), &watch};
  Result<EngineSession> session = run_engine_session(log, *project, how, folder.path());
  if (!session.ok()) return session.error();
  for (std::size_t i = 0; i < std::min(kWarningsShown, session->warnings.size()); ++i) {
    std::cerr << "tumble replay: warning: " << printable(session->warnings[i]) << '\n';
  }
  if (session->warnings.size() > kWarningsShown) {
    std::cerr << "tumble replay: warning: " << session->warnings.size() - kWarningsShown
              << " more; 'tumble import' of what the engine writes has them all\n";
  }
  if (!options.output.empty()) {
    if (Status ok = keep(session->log, options.output); !ok.ok()) return ok.error();
  }
  Result<replay::LogReader> again = open_log(session->log);
  if (!again.ok()) return again.error();
  if (!again->header().engine) {
    return bad_input(project->file.string() + ": run wrote a log of Tumble's own physics, wanted one of " +
                     printable(to_string(*log.header().engine)));
  }
  return compare_with(log, *again, *session, options);
}

}  // namespace tumble::tools
