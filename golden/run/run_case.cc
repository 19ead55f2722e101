#include "golden/run/run_case.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <utility>

#include "golden/expected/expected_file.h"
#include "golden/judge/case_series.h"
#include "golden/run/external_engine.h"
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

class CaseRunner {
 public:
  CaseRunner(const CaseFolder& folder, const RunOptions& options) : folder_(folder), options_(options) {
    CaseResult& result = run_.result;
    result.name = folder.name;
    result.problems = folder_problems(folder);
    result.require = options.require.value_or(CaseRules().require);
    result.reproduce = "tumble record " + shell_quoted(scene_path()) + " -o " + folder.name + ".tumble";
    const std::string suite = shell_quoted(options.suite.string());
    const std::string where = suite == "golden" ? "" : " --suite " + suite;
    result.bless = "tumble bless " + folder.name + where + " --reason \"…\"";
  }

  CaseRun run() {
    if (read_scene() && read_rules()) {
      read_expected();
      judge_session();
    }
    return std::move(run_);
  }

 private:
  [[nodiscard]] std::string scene_path() const { return folder_.file(kSceneFile).string(); }

  bool fail(const Error& error) {
    run_.result.problems.push_back(error.message);
    return false;
  }

  bool read_scene() {
    std::error_code ignored;
    if (!fs::exists(folder_.file(kSceneFile), ignored)) return false;  // is a problem already
    Result<std::string> text = read_text(folder_.file(kSceneFile));
    if (!text.ok()) return fail(text.error());
    Result<sim::SceneDef> scene = scenes::parse_scene(*text, scene_path());
    if (!scene.ok()) return fail(scene.error());
    scene_text_ = *std::move(text);
    scene_ = *std::move(scene);
    run_.result.title = scene_.title;
    run_.result.category = scene_.category;
    return true;
  }

  bool read_rules() {
    std::error_code ignored;
    if (!fs::exists(folder_.file(kRulesFile), ignored)) return false;
    const Result<std::string> text = read_text(folder_.file(kRulesFile));
    if (!text.ok()) return fail(text.error());
    Result<CaseRules> rules = parse_rules(*text, folder_.file(kRulesFile).string());
    if (!rules.ok()) return fail(rules.error());
    run_.rules = *std::move(rules);
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
    const Result<Session> session =
        is_external ? run_engine(run_.rules.command, options_.suite, scene_path()) : run_session(scene_, scene_text_);
    if (is_external) run_.result.reproduce = engine_command(run_.rules.command, scene_path(), folder_.name + ".tumble");
    if (!session.ok()) {
      fail(session.error());
      return;
    }
    Result<replay::LogReader> log = open_session(*session, folder_.name + "'s log");
    if (!log.ok()) {
      fail(log.error());
      return;
    }
    const Reference reference = {run_.rules, expected_ ? &*expected_ : nullptr, scene_hash(scene_),
                                 session->continuation};
    Judged judged = judge(*log, reference);
    const bool measured = judged.result.problems.empty() || !judged.values.empty();
    take(std::move(judged));
    take(judge_pictures(*log, run_.rules.pictures, folder_));
    if (!session->failure.empty()) run_.result.problems.push_back(session->failure);
    run_.complete = measured && session->failure.empty() && log->condition().whole();
    if (!run_.result.passed()) leave_files(*session, *log);
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
    run_.actual = std::move(judged.actual);
    run_.values = std::move(judged.values);
  }

  void take(JudgedPictures&& judged) {
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
    leave("actual.tumble", std::span<const std::byte>(*session.log));
    for (std::size_t k = 0; k < run_.pictures.size(); ++k) {
      if (run_.result.pictures[k].message.empty() || run_.pictures[k].png.empty()) continue;
      for (const PictureFile& file : explaining_files(run_.pictures[k])) {
        leave(file.name, std::span<const std::byte>(file.bytes));
      }
    }
    if (expected_ && !expected_->track.empty()) leave("expected_track.csv", std::string_view(track_csv(*expected_)));
    const Result<Json> series = case_series(log, expected_ ? &*expected_ : nullptr);
    if (series.ok()) {
      leave(kSeriesFile, std::string_view(series->dump()));
    } else {
      run_.result.notes.push_back("nothing to draw: " + series.error().message);
    }
  }

  const CaseFolder& folder_;
  const RunOptions& options_;
  CaseRun run_;
  std::string scene_text_;
  sim::SceneDef scene_;
  std::optional<Expected> expected_;
};

}  // namespace

CaseRun run_case(const CaseFolder& folder, const RunOptions& options) { return CaseRunner(folder, options).run(); }

}  // namespace tumble::golden
