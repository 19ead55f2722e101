#include "golden/run/run_case.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "golden/expected/expected_file.h"
#include "golden/judge/case_series.h"
#include "golden/judge/judge.h"
#include "golden/run/external_engine.h"
#include "golden/run/obstacle.h"
#include "golden/run/run_session.h"
#include "golden/suite/parse_rules.h"
#include "golden/suite/scene_hash.h"
#include "golden/suite/text_files.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

std::string track_csv(const Expected& expected) {
  std::string text = "step,id,x_m,y_m,z_m\n";
  for (const TrackPoint& point : expected.track) {
    for (std::size_t i = 0; i < point.id.size(); ++i) {
      text += std::to_string(point.step) + ',' + std::to_string(point.id[i]);
      for (const std::int32_t mm : {point.x[i], point.y[i], point.z[i]}) text += ',' + std::to_string(mm / 1000.0);
      text += '\n';
    }
  }
  return text;
}

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
    if (read_scene() && read_rules()) {
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
    run_.result.title = scene_.title;
    run_.result.category = scene_.category;
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
    if (!bytes.ok()) {
      fail(bytes.error());
      return;
    }
    Result<Expected> expected = unpack(*bytes, folder_.file(kExpectedFile).string());
    if (expected.ok()) {
      expected_ = *std::move(expected);
    } else {
      fail(expected.error());
    }
  }

  void judge_session() {
    const bool is_external = !run_.rules.command.empty();
    const Result<Session> session = this_session(is_external);
    if (!session.ok()) {
      stop(session.error());
      return;
    }
    Result<replay::LogReader> log = open_session(*session, folder_.name + "'s log");
    if (!log.ok()) {
      stop(log.error());
      return;
    }
    const Reference reference = {run_.rules, expected_ ? &*expected_ : nullptr, scene_hash(scene_),
                                 session->continuation, scene_text_};
    Judged judged = judge(*log, reference);
    run_.incomplete = reason_to_stop(*session, *log, judged);
    take(std::move(judged));
    if (recorded_ != nullptr && run_.incomplete.empty() && recorded_->final_hash != run_.result.final_hash) {
      stop(bad_input("the report's session does not end as the report says"));
      return;
    }
    take_pictures(*log);
    if (!session->failure.empty()) run_.result.problems.push_back(session->failure);
    if (!run_.result.passed()) leave_files(*session, *log);
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
    Result<Session> session = is_external
                                  ? run_engine(run_.rules.command, options_.suite, scene_path(), options_.scratch)
                                  : run_session(scene_, scene_text_);
    if (session.ok()) provenance_.seconds = session->seconds;
    return session;
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

  void leave_files(const Session& session, replay::LogReader& log) {
    if (options_.report.empty()) return;
    const std::string folder = "cases/" + folder_.name + "/";
    const auto leave = [&](const std::string& name, const auto& content) {
      if (Status ok = write_file(options_.report / (folder + name), content); !ok.ok()) {
        fail(ok.error());
      } else {
        run_.result.artifacts.push_back(folder + name);
      }
    };
    leave(kLogFile, std::span<const std::byte>(*session.log));
    for (std::size_t k = 0; k < run_.pictures.size(); ++k) {
      if (run_.result.pictures[k].message.empty() || run_.pictures[k].png.empty()) continue;
      for (const PictureFile& file : explaining_files(run_.pictures[k])) {
        leave(file.name, std::span<const std::byte>(file.bytes));
      }
    }
    if (expected_ && !expected_->track.empty()) leave(kTrackFile, std::string_view(track_csv(*expected_)));
    const Result<Json> series = case_series(log, expected_ ? &*expected_ : nullptr);
    if (series.ok()) {
      leave(kSeriesFile, std::string_view(series->dump()));
    } else {
      run_.result.notes.push_back("nothing to draw: " + series.error().message);
    }
  }

  const CaseFolder& folder_;
  const RunOptions& options_;
  const RecordedCase* recorded_ = nullptr;  // null: the case is run
  CaseRun run_;
  std::string scene_text_;
  sim::SceneDef scene_;
  std::optional<Expected> expected_;
  Provenance provenance_ = this_program();
};

}  // namespace

std::string reproduce_command(const CaseFolder& folder, const fs::path& suite, const CaseRules& rules) {
  if (!rules.command.empty()) return engine_line(rules.command, suite, folder);
  return "tumble record " + shell_quoted(folder.file(kSceneFile).string()) + " -o " +
         shell_quoted(folder.name + ".tumble");
}

CaseRun run_case(const CaseFolder& folder, const RunOptions& options) { return CaseRunner(folder, options).run(); }

}  // namespace tumble::golden
