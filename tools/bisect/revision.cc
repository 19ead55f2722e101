#include "tools/bisect/revision.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "golden/suite/text_files.h"
#include "replay/diff/difference_report.h"
#include "replay/measure/measure_log.h"
#include "src/base/check.h"
#include "src/process/run_child.h"
#include "src/scenes/problem.h"
#include "tools/bisect/asked_sessions.h"
#include "tools/files/json_values.h"
#include "tools/files/log_files.h"
#include "tools/output/text.h"
#include "tumble/replay/compare.h"

namespace tumble::tools::bisect {
namespace {

namespace fs = std::filesystem;

/// The last line of a file that is not blank.
std::string last_line(const std::string& path) {
  const Result<std::string> text = golden::read_text(path);
  if (!text.ok()) return "";
  std::string last;
  for (const std::string& line : golden::lines_of(*text)) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  }
  return printable(last.substr(0, 300));
}

Json json_of(const std::string& path) {
  const Result<std::string> text = golden::read_text(path);
  return text.ok() ? Json::parse(*text, nullptr, false) : Json();
}

Answer answered(bool yes, const std::string& words) { return {.asked = true, .yes = yes, .message = words}; }

constexpr std::size_t kAsksIfDifferent = 5;
constexpr std::size_t kReasonShown = 300;  // bytes of the line that says why a build failed

bool alike(const Answer& a, const Answer& b) { return a.asked == b.asked && a.yes == b.yes; }

}  // namespace

Status Asker::prepare() {
  if (!settings_.log.empty()) {
    if (Status ok = recording_.prepare(); !ok.ok()) return ok;
  }
  std::error_code error;
  if (!fs::exists(place_.source(), error)) return git_.clone_to(place_.source());
  built_before_ = true;
  return {};
}

/// False, and the reason in `why`, if the program did not end well.
Result<bool> Asker::run(const Recording::Command& command, const std::string& name, std::string& why) {
  const std::vector<std::string>& words = command.words;
  process::Program task;
  task.words = words;
  task.folder = command.folder;
  task.out = place_.file(name + ".out");
  task.err = place_.file(name + ".err");
  const Result<process::ChildEnd> end = process::run_child(task, settings_.timeout_s, cancel_);
  if (!end.ok()) {
    why = end.error().message;
    last_exit_ = -1;
    return false;
  }
  if (end->stopped) return cannot_finish("interrupted");
  last_exit_ = end->late ? -1 : end->exit;
  if (end->well()) return true;
  const std::string said = last_line(task.err);
  why = fs::path(words.front()).filename().string() + ' ' + end->text() + (said.empty() ? "" : ": " + said);
  return false;
}

Result<bool> Asker::build_once(const std::string& log, BuildProgress& progress, std::string& why) {
  const auto show_and_ask = [&] {
    if (!quiet_) progress.show();
    return cancel_ && cancel_();
  };
  const golden::EngineProject project = recording_.engine();
  for (const std::string& command : project.build) {
    const Result<std::vector<std::string>> words = golden::engine_words(project, command, {});
    if (!words.ok()) return words.error();
    process::Program task;
    task.words = *words;
    task.folder = project.folder.string();
    task.out = task.err = log;
    // The compiler cache then finds objects that were compiled in other folders.
    task.more = {{"CCACHE_BASEDIR", place_.source()}, {"CCACHE_NOHASHDIR", "1"}};
    const Result<process::ChildEnd> end = process::run_child(task, 0, show_and_ask);
    if (!end.ok()) return end.error();
    if (end->stopped) return cannot_finish("interrupted");
    if (end->well()) continue;
    const Result<std::string> output = golden::read_text(log);
    const std::string reason = output.ok() ? printable(failure_in(*output).substr(0, kReasonShown)) : "";
    why = "does not build: " + words->front() + ' ' + end->text();
    if (!reason.empty()) why += ": " + reason;
    why += "; --keep leaves its output in ";
    why += log;
    return false;
  }
  return true;
}

/// Said once: a build from scratch each time costs the hours that a search takes.
Status Asker::note_left_over() {
  if (!built_before_ || quiet_ || told_left_over_) return {};
  const Result<std::string> names = git_.left_over(place_.source());
  if (!names.ok()) return names.error();
  if (names->empty()) return {};
  told_left_over_ = true;
  std::clog << "tumble bisect: note: what a build leaves and git does not ignore is removed before the next revision, "
               "which is then built from scratch: "
            << printable(names->substr(0, kReasonShown)) << "; name it in .git/info/exclude to keep it\n";
  return {};
}

/// Builds on top of the build before, which is quick. If that fails, builds from scratch: files that the other build
/// left may be the reason.
Result<bool> Asker::build(const std::string& commit, std::string& why) {
  const std::string log = place_.file("build_" + commit.substr(0, 10) + ".txt");
  if (Status ok = note_left_over(); !ok.ok()) return ok.error();
  if (Status ok = git_.put(place_.source(), commit, false); !ok.ok()) return ok.error();
  recording_.use_kept("");
  const bool keeps = cache_ != nullptr && !recording_.runs_engine();
  if (keeps) {
    const std::string kept = place_.file("kept/" + fs::path(settings_.program).filename().string());
    if (cache_->take(commit, kept)) {
      recording_.use_kept(kept);
      return true;
    }
  }
  BuildProgress progress(log);
  Result<bool> built = build_once(log, progress, why);
  if (built.ok() && !*built && built_before_) {
    if (Status ok = git_.put(place_.source(), commit, true); !ok.ok()) return ok.error();
    built = build_once(log, progress, why);
  }
  built_before_ = true;
  std::error_code error;  // a build that made no program is the revision's fault, which running it shows
  if (built.ok() && *built && keeps && fs::exists(recording_.program(), error)) {
    if (Status ok = cache_->keep(commit, recording_.program()); !ok.ok()) return ok.error();
  }
  return built;
}

Result<bool> Asker::record(const std::string& commit, std::string& why) {
  std::error_code error;
  const std::string session = place_.session(commit);
  fs::remove(session, error);
  const Result<Recording::Command> command = recording_.command(session);
  if (!command.ok()) {
    why = command.error().message;
    return false;
  }
  Result<bool> recorded = run(*command, "record", why);
  if (recorded.ok() && *recorded) {
    const golden::EngineProject engine = recording_.engine();
    Status made = golden::rewrite_table(session, engine.table, engine.folder);
    if (made.ok()) made = recording_.make_log(session);
    if (made.ok()) return recorded;
    why = fs::path(command->words.front()).filename().string() + ' ' + made.error().message;
    recorded = false;
  }
  fs::remove(session, error);
  return recorded;
}

Result<Answer> Asker::ask_replay() {
  std::string why;
  const Result<bool> same =
      run({{recording_.program(), "replay", settings_.log, "--json"}, place_.source()}, "replay", why);
  if (!same.ok()) return same.error();
  if (!*same && last_exit_ != 1) return skipped(why);
  const Json report = json_of(place_.file("replay.out"));
  if (*same) return answered(true, same_text(report));
  const Json first = member(report, "first");
  Answer answer = answered(false, differs_text(first));
  answer.outcome = first.dump(-1, ' ', false, Json::error_handler_t::replace);
  return answer;
}

/// Judges the session that the revision recorded. This build judges, so that all revisions are judged alike.
Result<Answer> Asker::ask_session(const std::string& commit) {
  Result<replay::LogReader> log = open_log(place_.session(commit));
  if (!log.ok()) return skipped("wrote no session that can be read: " + log.error().message);
  if (!settings_.metric) {
    Result<replay::LogReader> wanted = open_log(settings_.log);
    if (!wanted.ok()) return wanted.error();
    Result<replay::DiffReport> report = replay::diff_logs(*wanted, *log);
    if (!report.ok()) return skipped(report.error().message);
    replay::name_by_own_axes(wanted->header(), log->header(), *report, nullptr);
    if (report->computed_again()) return answered(true, same_text(report->scope));
    Answer answer = answered(
        false, report->first ? replay::describe(*report->first) : report->unequal("the log", "the revision's session"));
    const Result<const replay::StepRecord*> last = log->read_hashes(log->last_step());
    answer.outcome = answer.message + (last.ok() ? "; " + to_string((*last)->state_hash) : "");
    return answer;
  }
  const Result<replay::Metrics> metrics = replay::measure_log(*log, settings_.measure);
  if (!metrics.ok()) return skipped(metrics.error().message);
  if (Status ok = replay::check_measured(*metrics); !ok.ok()) return skipped(ok.error().message);
  const replay::MetricBound& bound = *settings_.metric;
  replay::Metrics measured = *metrics;
  if (bound.metric->needs_other_session()) {
    Result<replay::LogReader> wanted = open_log(settings_.log);
    if (!wanted.ok()) return wanted.error();
    Result<std::vector<replay::Parting>> partings = replay::measure_partings(*log, *wanted, {bound.metric->beyond});
    if (!partings.ok()) return skipped(partings.error().message);
    measured.partings = *std::move(partings);
  }
  const replay::EngineAxes axes = log->header().axes();
  Answer answer;
  answer.asked = true;
  answer.metric = bound.metric->value_in(axes, measured);
  answer.yes = bound.holds(answer.metric);
  answer.message =
      bound.metric->name + (" is " + bound.found_text(axes, measured)) + (answer.yes ? "" : ", out of bound");
  return answer;
}

Result<Answer> Asker::ask_case() {
  std::vector<std::string> words = {recording_.program(), "check",    settings_.case_name,   "--suite",
                                    recording_.suite(),   "--report", place_.file("report"), "--json"};
  if (settings_.image) words.insert(words.end(), {"--require", "image"});
  std::string why;
  const Result<bool> passed = run({words, place_.source()}, "check", why);
  if (!passed.ok()) return passed.error();
  if (!*passed && last_exit_ != 1) return skipped(why);
  const Json report = json_of(place_.file("check.out"));
  const Json cases = member(report, "cases");
  if (!cases.is_array() || cases.empty()) return skipped("check printed no report that can be read");
  const Json& result = cases[0];
  if (!settings_.image) return answered(*passed, text_in(result, "summary", *passed ? "passed" : "failed"));
  const Json verdict = member(member(result, "verdicts"), "image");
  const std::string outcome = text_in(verdict, "outcome", "none");
  if (outcome == "none") return skipped("no image verdict: " + text_in(verdict, "words", "the case has no picture"));
  return answered(outcome == "pass", text_in(verdict, "words", outcome));
}

Result<Answer> Asker::ask_once(const std::string& commit) {
  std::string why;
  const Result<bool> recorded = record(commit, why);
  if (!recorded.ok()) return recorded.error();
  if (!settings_.case_name.empty()) return ask_case();
  if (!settings_.metric && settings_.run.empty()) return ask_replay();
  if (!*recorded) return skipped(why);
  return ask_session(commit);
}

/// Asks until two answers agree; then as often as an answer needs that changes from time to time.
Result<Answer> Asker::ask(const std::string& commit) {
  std::string why;
  const Result<bool> built = build(commit, why);
  if (!built.ok()) return built.error();
  if (!*built) return skipped(why);
  std::vector<Answer> answers;
  AskedSessions sessions(place_.session(commit));
  std::size_t wanted = settings_.asks;
  while (answers.size() < wanted) {
    Result<Answer> answer = ask_once(commit);
    if (!answer.ok()) return answer.error();
    answers.push_back(*std::move(answer));
    sessions.add();
    if (!alike(answers.front(), answers.back())) wanted = std::max<std::size_t>(settings_.asks, kAsksIfDifferent);
  }
  Answer answer = answer_of(answers);
  const auto of = std::ranges::find(answers, answer.message, &Answer::message);
  sessions.keep(of == answers.end() ? 0 : static_cast<std::size_t>(of - answers.begin()));
  answer.sessions_differ = sessions.difference();
  return answer;
}

}  // namespace tumble::tools::bisect
