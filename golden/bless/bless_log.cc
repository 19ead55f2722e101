#include "golden/bless/bless_log.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <system_error>

#include "golden/bless/rewrite_scene.h"
#include "golden/expected/expected_file.h"
#include "golden/run/run_session.h"
#include "golden/suite/scene_hash.h"
#include "golden/suite/text_files.h"
#include "src/base/text.h"
#include "src/files/output_file.h"
#include "src/scenes/problem.h"
#include "tumble/golden/judge.h"
#include "tumble/replay/compare.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

/// The metrics that a new case starts with; those that read null are left out.
struct FirstRule {
  const char* name;
  const char* why;
};
constexpr std::array kFirstRules = {
    FirstRule{"gain_ratio", "nothing may gain energy; the session's own gain and a tenth more"},
    FirstRule{"lost", "as many as in the session, which should be none"},
    FirstRule{"drift_max", "where the session ended, and a tenth more"},
    FirstRule{"top_drop_max", "how far it sank or fell in the session, and a tenth more"},
    FirstRule{"overlap_max", "no deeper than in the session, and a tenth more"},
    FirstRule{"ground_penetration_max", "no deeper than in the session, and a tenth more"},
};

CaseRules first_rules() {
  CaseRules rules;
  for (const FirstRule& first : kFirstRules) {
    MetricRule rule;
    rule.name = first.name;
    rule.why = first.why;
    rules.metrics.push_back(rule);
  }
  return rules;
}

/// A tenth above, in two digits; 0 stays 0.
double bound_above(double value) {
  if (value <= 0) return value;
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::ceil(value * 1.1 / unit) * unit;
}

std::string rules_text(const CaseRules& rules, const std::vector<std::optional<double>>& values,
                       const std::string& reason) {
  std::string text = "# " + reason + "\n# Bounds were made from the recorded session: review them.\n";
  for (std::size_t k = 0; k < rules.metrics.size(); ++k) {
    if (!values[k]) continue;
    const double bound = rules.metrics[k].name == "lost" ? *values[k] : bound_above(*values[k]);
    text += "\n[[metric]]\nname = \"" + rules.metrics[k].name + "\"\nmax = " + number_text(bound) +
            "\nvalue = " + number_text(*values[k]) + "\nwhy = \"" + rules.metrics[k].why + "\"\n";
  }
  return text;
}

Status check_request(const NewCase& options) {
  if (options.reason.find_first_not_of(' ') == std::string::npos || options.reason.find('\n') != std::string::npos) {
    return bad_input("--reason: wanted one line that says why there is this case");
  }
  if (Status ok = check_case_name(options.name); !ok.ok()) return ok;
  std::error_code error;
  const fs::path folder = options.suite / "cases" / options.name;
  if (!fs::is_directory(options.suite, error)) return bad_input(options.suite.string() + ": no such suite");
  if (fs::exists(folder, error)) return bad_input(folder.string() + ": is there already; choose another name");
  if (options.dry_run) return {};
  const fs::path cases = options.suite / "cases";
  const fs::path& place = fs::is_directory(cases, error) ? cases : options.suite;
  return files::can_write_in(place, place);
}

/// The scene of a log as the file of a case.
Result<std::string> scene_text(const NewCase& options, const replay::LogReader& log) {
  const replay::LogHeader& header = log.header();
  if (header.goes_on) {
    return bad_input(options.log + ": goes on from step " + std::to_string(header.goes_on->step) + " of " +
                     printable(header.goes_on->log) +
                     ", and a case starts with its scene; make the case of a session recorded from the scene's start");
  }
  if (header.scene_text.empty()) {
    return bad_input(options.log + ": holds no scene text, so no scene.toml can be made of it");
  }
  return rewrite_scene(header.scene_text, options.log, options.name, header.overrides);
}

/// The first input that the log applied and its scene does not have, as "dt before step 1"; empty: none.
Result<std::string> input_beside_scene(replay::LogReader& log) {
  const std::vector<sim::TimedCommand>& planned = log.header().scene.inputs;
  for (std::uint64_t k = log.first_state() + 1; k <= log.last_step(); ++k) {
    const Result<const replay::StepRecord*> step = log.read_hashes(k);
    if (!step.ok()) return step.error();
    for (const sim::Command& input : (*step)->inputs) {
      if (std::ranges::find(planned, sim::TimedCommand{k, input}) != planned.end()) continue;
      return std::string(sim::name_of(input)) + " before step " + std::to_string(k);
    }
  }
  return std::string();
}

/// Why a session is not the one that its scene text makes, where the log tells, and what to do.
Result<std::string> why_not_of_scene(replay::LogReader& log) {
  const replay::LogHeader& header = log.header();
  if (!header.transform.identity()) {
    return "its scene was transformed when it was recorded (" + to_string(header.transform) +
           "), which a scene file cannot say; make the case of a session recorded without";
  }
  const Result<std::string> input = input_beside_scene(log);
  if (!input.ok()) return input.error();
  if (!input->empty()) {
    return "it has inputs that its scene does not have, made while it ran (live, or --realtime; the first: " + *input +
           "); write them into the scene as [[input]] and record that";
  }
  return std::string("record it with this build first");
}

Status must_be_the_same(replay::LogReader& recorded, replay::LogReader& again, const std::string& path) {
  Result<replay::DiffReport> diff = replay::diff_logs(recorded, again);
  if (!diff.ok()) return diff.error();
  if (diff->identical() && diff->from == 0) return {};
  const Result<std::string> why = why_not_of_scene(recorded);
  if (!why.ok()) return why.error();
  std::string where = diff->first ? replay::describe(*diff->first) : diff->unequal("the session", "this build's");
  if (!where.empty()) where.insert(0, ": ");
  return bad_input(path + ": this build does not reproduce the session from its scene" + where + "; " + *why);
}

}  // namespace

Result<BlessReport> bless_log(const NewCase& options) {
  if (Status ok = check_request(options); !ok.ok()) return ok.error();
  Result<replay::LogReader> recorded = replay::LogReader::open(options.log);
  if (!recorded.ok()) return recorded.error();
  if (!recorded->condition().whole()) {
    return damaged(options.log + ": wanted a whole log to make a case of; " +
                   recorded->condition().summary(recorded->last_step()) + "; record the session again");
  }
  const Result<std::string> text = scene_text(options, *recorded);
  if (!text.ok()) return text.error();
  const CaseFolder folder{options.name, options.suite / "cases" / options.name};
  const Result<sim::SceneDef> scene = scenes::parse_scene(*text, kSceneFile);
  if (!scene.ok()) {
    return Error{scene.error().kind, options.log +
                                         ": no case can be made of the scene that it holds, with its overrides: " +
                                         scene.error().message + "; change the scene and record it again"};
  }

  const Result<Session> session = run_session(*scene, *text);
  if (!session.ok()) return session.error();
  if (!session->failure.empty()) {
    return bad_input(options.log + ": its scene ends early, so no check of it could pass: " + session->failure);
  }
  Result<replay::LogReader> log = open_session(*session, options.name);
  if (!log.ok()) return log.error();
  if (Status ok = must_be_the_same(*recorded, *log, options.log); !ok.ok()) return ok.error();

  const CaseRules rules = first_rules();
  Judged judged = judge(*log, {rules, nullptr, scene_hash(*scene), session->continuation});
  if (!judged.result.problems.empty()) return bad_input(options.log + ": " + judged.result.problems.front());
  if (std::ranges::none_of(judged.values, [](const std::optional<double>& value) { return value.has_value(); })) {
    return bad_input(options.log + ": every metric of a new case reads null, so that nothing would be judged");
  }
  judged.actual.scene_text = *text;
  judged.actual.provenance = this_program();
  judged.actual.provenance.seconds = session->seconds;
  const Result<std::vector<std::byte>> golden = pack(judged.actual);
  if (!golden.ok()) return golden.error();

  Blessing blessing{.name = options.name, .is_new = true, .bits = {}, .details = {}, .metrics = judged.result.metrics};
  blessing.bits = "new, " + count_text(judged.result.steps, "step") + " of " + count_text(judged.result.bodies, "body");
  std::erase_if(blessing.metrics, [](const MetricResult& metric) { return !metric.value; });
  const BlessReport report{.blessed = {blessing}, .unchanged = {}};
  if (options.dry_run) return report;
  Status ok = write_file(folder.file(kSceneFile), std::string_view(*text));
  if (ok.ok()) ok = write_file(folder.file(kRulesFile), rules_text(rules, judged.values, options.reason));
  if (ok.ok()) ok = write_file(folder.file(kExpectedFile), std::span<const std::byte>(*golden));
  if (ok.ok()) ok = add_to_history(options.suite, history_entry(options.reason, report.blessed));
  if (!ok.ok()) return ok.error();
  return report;
}

}  // namespace tumble::golden
