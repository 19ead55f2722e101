#include "golden/run/run_case.h"

#include <optional>
#include <utility>

#include "golden/expected/expected_file.h"
#include "golden/run/engine_files.h"
#include "golden/run/external_engine.h"
#include "golden/run/go_on.h"
#include "golden/run/judge_laws.h"
#include "golden/run/obstacle.h"
#include "golden/run/repeated_runs.h"
#include "golden/run/run_session.h"
#include "golden/suite/parse_rules.h"
#include "golden/suite/scene_hash.h"
#include "golden/suite/text_files.h"
#include "src/base/text.h"
#include "tumble/golden/judge.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

std::string bless_command(const CaseFolder& folder, const fs::path& suite) {
  return "tumble bless " + shell_quoted(folder.name) + suite_option(suite) + " --reason \"…\"";
}

class CaseRunner {
 public:
  CaseRunner(const CaseFolder& folder, const RunOptions& options) : folder_(folder), options_(options) {
    const auto recorded = options.recorded.find(folder.name);
    if (recorded != options.recorded.end()) recorded_ = &recorded->second;
    CaseResult& result = run_.result;
    result.name = folder.name;
    result.problems = folder_problems(folder);
    result.require = options.require.value_or(CaseRules().require);
  }

  CaseRun run() {
    std::error_code ignored;
    const bool has_scene = fs::exists(folder_.file(kSceneFile), ignored) && !engine_case(folder_);
    const bool is_ready = has_scene ? read_scene() && read_rules() : read_rules() && read_engine_files();
    if (is_ready) {
      read_expected();
      judge_session();
    }
    CaseResult& result = run_.result;
    result.bless_refused = obstacle_to_bless(run_, folder_.file(kRulesFile));
    if (result.bless_refused.empty()) result.bless = bless_command(folder_, options_.suite);
    return std::move(run_);
  }

 private:
  [[nodiscard]] std::string scene_path() const { return folder_.file(kSceneFile).string(); }

  void fail(const Error& error) { run_.result.problems.push_back(error.message); }

  /// A problem that ends the run.
  bool stop(const Error& error) {
    run_.incomplete = error.message;
    run_.unable = error.kind == ErrorKind::kCannotFinish;
    fail(error);
    return false;
  }

  /// A file without which nothing is run. folder_problems() has named it among the problems.
  bool has(const char* name) {
    std::error_code ignored;
    if (fs::exists(folder_.file(name), ignored)) return true;
    run_.incomplete = std::string("it has no ") + name;
    return false;
  }

  bool read_scene() {
    if (!has(kSceneFile)) return false;
    Result<std::string> text = read_text(folder_.file(kSceneFile));
    if (!text.ok()) return stop(text.error());
    Result<sim::SceneDef> scene = scenes::parse_scene(*text, scene_path());
    if (!scene.ok()) return stop(scene.error());
    scene_text_ = *std::move(text);
    scene_ = *std::move(scene);
    source_hash_ = scene_hash(scene_);
    run_.result.title = scene_.title;
    run_.result.category = scene_.category;
    return true;
  }

  /// The files of an engine's case, which take the place of a scene.
  bool read_engine_files() {
    if (!run_.rules.engine) return has(kSceneFile) && read_scene();
    Result<std::string> text = engine_files_text(folder_, *run_.rules.engine);
    if (!text.ok()) return stop(text.error());
    scene_text_ = *std::move(text);
    source_hash_ = engine_files_hash(scene_text_);
    run_.result.title = run_.rules.engine->title;
    run_.result.category = run_.rules.engine->category;
    return true;
  }

  bool read_rules() {
    if (!has(kRulesFile)) return false;
    Result<CaseRules> rules = golden::read_rules(folder_.file(kRulesFile));
    if (!rules.ok()) return stop(rules.error());
    run_.rules = *std::move(rules);
    run_.result.reproduce = reproduce_command(folder_, options_.suite, run_.rules);
    if (!options_.require) run_.result.require = run_.rules.require;
    return true;
  }

  void read_expected() {
    std::error_code ignored;
    if (!fs::exists(folder_.file(kExpectedFile), ignored)) return;
    const Result<std::vector<std::byte>> bytes = read_bytes(folder_.file(kExpectedFile));
    if (!bytes.ok()) return fail(bytes.error());
    Result<Expected> expected = unpack(*bytes, folder_.file(kExpectedFile).string());
    if (!expected.ok()) return fail(expected.error());
    expected_ = *std::move(expected);
  }

  void judge_session() {
    const bool is_external = run_.rules.is_external();
    const Result<Session> session = this_session(is_external);
    if (!session.ok()) {
      stop(session.error());
      return;
    }
    if (session->was_converted) {
      run_.result.reproduce = reproduce_command(folder_, options_.suite, run_.rules, true);
    }
    Result<replay::LogReader> log = open_session(*session, folder_.name + "'s log");
    if (!log.ok()) {
      stop(log.error());
      return;
    }
    const Reference reference = {run_.rules,   expected_ ? &*expected_ : nullptr,
                                 source_hash_, session->continuation,
                                 scene_text_,  session->cut_short};
    Judged judged = judge(*log, reference);
    const std::uint64_t runs = runs_wanted(run_.rules, options_.to_bless && recorded_ == nullptr);
    const bool repeats = runs > 1 && !session->cut_short && session->failure.empty();
    if (repeats && !judge_repeated(*log, reference, runs, judged)) return;
    run_.incomplete = reason_to_stop(*session, *log, judged);
    run_.unable = !session->failure.empty();
    take(std::move(judged));
    if (recorded_ != nullptr && run_.incomplete.empty() && recorded_->final_hash != run_.result.final_hash) {
      stop(bad_input("the report's session does not end as the report says"));
      return;
    }
    if (!session->failure.empty()) run_.result.problems.push_back(session->failure);
    if (!session->cut_short) {
      const LawSession judged_session = {folder_, options_.suite, *log, scene_, recorded_ == nullptr, options_.scratch};
      judge_laws(judged_session, run_.rules, run_.result);
      if (options_.heavy && session->failure.empty()) go_on_from_each_step(judged_session, run_.rules, run_.result);
    }
    session->cut_short ? tell_how_far() : take_pictures(*log);
    if (!run_.result.passed()) leave_case_files(run_, options_.report, *session, *log, expected_);
  }

  /// Of an engine that failed: its steps say where it went wrong, and no verdict is given on them.
  void tell_how_far() {
    CaseResult& result = run_.result;
    const std::string steps = count_text(result.steps, "step");
    const bool differs = result.difference && result.difference->step <= result.steps;
    std::string message = "it wrote " + steps + " before it failed";
    if (expected_ && differs) message += "; " + result.verdict(VerdictKind::kExact).message;
    if (expected_ && !differs) {
      message += ", with the same bits as the golden, which has " + count_text(expected_->steps(), "step");
    }
    result.problems.push_back(message);
    for (Verdict& verdict : result.verdicts) verdict = {Outcome::kNone, "not judged: the engine failed"};
    result.metrics.clear();
  }

  /// Runs the engine `count` times, and judges all runs together.
  bool judge_repeated(replay::LogReader& log, const Reference& reference, std::uint64_t count, Judged& judged) {
    if (recorded_ != nullptr) {
      judged.result.notes.push_back("one run of the engine is judged: the report has no other");
      return true;
    }
    RepeatedRuns runs(log, reference, judged);
    for (std::uint64_t k = 2; k <= count; ++k) {
      const Result<Session> session = this_session(true);
      if (!session.ok()) return stop(session.error());
      if (!session->failure.empty()) {
        return stop(cannot_finish("run " + std::to_string(k) + ": " + session->failure));
      }
      Result<replay::LogReader> again = open_session(*session, folder_.name + "'s log of run " + std::to_string(k));
      if (!again.ok()) return stop(again.error());
      if (Status ok = runs.add(*again); !ok.ok()) return stop(ok.error());
    }
    runs.finish();
    return true;
  }

  /// Why a session that was judged may not become a golden; empty: it may.
  static std::string reason_to_stop(const Session& session, const replay::LogReader& log, const Judged& judged) {
    if (!session.failure.empty()) return session.failure;
    // A session that cannot be read or measured to its end has that problem last.
    if (judged.values.empty() && !judged.result.problems.empty()) return judged.result.problems.back();
    return log.condition().whole() ? "" : "its log is " + log.condition().summary(judged.result.steps);
  }

  /// Runs the case, or reads its session from the report of a check elsewhere.
  Result<Session> this_session(bool is_external) {
    if (recorded_ != nullptr) return recorded_session(is_external);
    if (!options_.recorded.empty())
      return bad_input("the report has no session of it: it passed there, or was not run");
    Result<Session> session = is_external ? engine_session() : run_session(scene_, scene_text_);
    if (session.ok()) provenance_.seconds = session->seconds;
    return session;
  }

  Result<Session> engine_session() {
    const Result<CaseEngine> engine = engine_of_case(folder_, run_.rules, options_.suite);
    if (!engine.ok()) return engine.error();
    return run_engine(*engine, options_.scratch);
  }

  Result<Session> recorded_session(bool is_external) {
    provenance_ = recorded_->run;
    if (!is_external && recorded_->continuation == Hash128{}) {
      return bad_input("the report does not say the hash of the hidden state that its session ends with");
    }
    Result<std::vector<std::byte>> bytes = read_bytes(recorded_->folder / kLogFile);
    if (!bytes.ok()) return bytes.error();
    Session session{std::make_shared<std::vector<std::byte>>(*std::move(bytes)), recorded_->continuation, {}, 0};
    Result<replay::LogReader> log = open_session(session, folder_.name + "'s log in the report");
    if (!log.ok()) return log.error();
    if (!is_external && scene_hash(log->header().scene) != scene_hash(scene_)) {
      return bad_input("the report's session is of another scene than " + scene_path());
    }
    return session;
  }

  void take(Judged&& judged) {
    CaseResult& result = run_.result;
    CaseResult& from = judged.result;
    result.steps = from.steps;
    result.bodies = from.bodies;
    result.verdicts = std::move(from.verdicts);
    result.problems.insert(result.problems.end(), from.problems.begin(), from.problems.end());
    result.notes = std::move(from.notes);
    result.runs = from.runs;
    result.runs_message = std::move(from.runs_message);
    result.metrics = std::move(from.metrics);
    result.difference = std::move(from.difference);
    result.final_hash = std::move(from.final_hash);
    result.continuation = std::move(from.continuation);
    result.scene_changes = std::move(from.scene_changes);
    result.blessed_by = std::move(from.blessed_by);
    run_.actual = std::move(judged.actual);
    run_.actual.scene_text = scene_text_;
    run_.actual.provenance = provenance_;
    run_.values = std::move(judged.values);
  }

  void take_pictures(replay::LogReader& log) {
    std::optional<RecordedPictures> recorded;
    if (recorded_ != nullptr) recorded.emplace(RecordedPictures{recorded_->folder, recorded_->pictures});
    JudgedPictures judged = judge_pictures(log, run_.rules.pictures, folder_, recorded ? &*recorded : nullptr);
    CaseResult& result = run_.result;
    result.verdict(VerdictKind::kImage) = std::move(judged.verdict);
    result.pictures = std::move(judged.results);
    result.problems.insert(result.problems.end(), judged.problems.begin(), judged.problems.end());
    result.notes.insert(result.notes.end(), judged.notes.begin(), judged.notes.end());
    run_.pictures = std::move(judged.drawn);
  }

  const CaseFolder& folder_;
  const RunOptions& options_;
  const RecordedCase* recorded_ = nullptr;  // null: the case is run
  CaseRun run_;
  std::string scene_text_;
  sim::SceneDef scene_;
  Hash128 source_hash_;  // of the scene, or of the engine's files
  std::optional<Expected> expected_;
  Provenance provenance_ = this_program();
};

}  // namespace

std::string reproduce_command(const CaseFolder& folder, const fs::path& suite, const CaseRules& rules, bool converts) {
  if (rules.is_external()) {
    const Result<CaseEngine> engine = engine_of_case(folder, rules, suite);
    return engine.ok() ? engine_line(*engine, folder.name, converts) : "";
  }
  return "tumble record " + shell_quoted(folder.file(kSceneFile).string()) + " -o " +
         shell_quoted(folder.name + ".tumble");
}

CaseRun run_case(const CaseFolder& folder, const RunOptions& options) { return CaseRunner(folder, options).run(); }

}  // namespace tumble::golden
