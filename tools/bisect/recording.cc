#include "tools/bisect/recording.h"

#include <cctype>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>

#include "golden/engine/inputs_file.h"
#include "golden/engine/session_file.h"
#include "golden/run/external_engine.h"
#include "golden/suite/parse_rules.h"
#include "golden/suite/text_files.h"
#include "replay/log/checked_log.h"
#include "tools/files/log_files.h"
#include "tools/output/text.h"
#include "tumble/golden/suite.h"

namespace tumble::tools::bisect {
namespace {

namespace fs = std::filesystem;

/// A name for both the file and the scene.
std::string file_name(const std::string& scene) {
  std::string name;
  for (const char c : scene) name += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' ? c : '_';
  return name.empty() ? "scene" : name;
}

/// `--mirror` and so on, as when the log was recorded.
std::vector<std::string> transform_words(const sim::Transform& transform) {
  std::vector<std::string> words;
  const auto mirror = [&](bool is_so, const char* axis) {
    if (is_so) words.insert(words.end(), {"--mirror", axis});
  };
  mirror(transform.mirror_x, "x");
  mirror(transform.mirror_y, "y");
  mirror(transform.swap_xy, "diagonal");
  if (transform.permute) words.insert(words.end(), {"--permute", std::to_string(*transform.permute)});
  if (transform.shift.x() != 0 || transform.shift.y() != 0) {
    words.insert(words.end(), {"--shift", exact(transform.shift.x()) + ',' + exact(transform.shift.y())});
  }
  return words;
}

/// Whether the session has inputs that its scene tells nothing of: made by a hand, or by `--realtime`.
Result<bool> has_more_inputs(replay::LogReader& log) {
  std::uint64_t of_scene = 0, of_steps = 0;
  for (const sim::TimedCommand& input : log.header().scene.inputs) of_scene += input.step <= log.last_step() ? 1U : 0U;
  for (std::uint64_t k = log.first_state() + 1; k <= log.last_step(); ++k) {
    const Result<const replay::StepRecord*> record = log.read_hashes(k);
    if (!record.ok()) return record.error();
    of_steps += (*record)->inputs.size();
  }
  return of_steps > of_scene;
}

}  // namespace

Status Recording::prepare() {
  Result<replay::LogReader> log = open_log(settings_.log);
  if (!log.ok()) return log.error();
  if (const Result<replay::VerifyReport> checked = replay::check_log(*log); !checked.ok()) return checked.error();
  const replay::LogHeader& header = log->header();
  files_.inputs = place_.file("scene/inputs.jsonl");
  const Result<std::string> inputs = golden::inputs_text(*log);
  if (!inputs.ok()) return inputs.error();
  if (Status ok = golden::write_file(files_.inputs, std::string_view(*inputs)); !ok.ok()) return ok;
  const std::string steps = std::to_string(log->step_count());
  record_words_ = {"--from", settings_.log + ':' + std::to_string(log->first_state()), "--steps", steps};
  files_.scene = settings_.scene;
  if (header.goes_on || header.scene_text.empty()) {
    if (settings_.run.find("{scene}") != std::string::npos && settings_.engine_scene.empty() && files_.scene.empty()) {
      return bad_input((settings_.has_project ? "run of tumble.toml" : "--run") + std::string(": found {scene}, and ") +
                       settings_.log +
                       " holds no scene text to put there; name the file by --scene, or each revision's own by scene = "
                       "\"…\" under [engine] of tumble.toml, a path from its folder; leave {scene} out, or record the "
                       "log from a scene");
    }
    return {};
  }
  if (!files_.scene.empty()) return {};
  files_.scene = place_.file("scene/" + file_name(header.scene.name) + ".toml");
  if (Status ok = golden::write_file(files_.scene, std::string_view(header.scene_text)); !ok.ok()) return ok;
  const Result<bool> more_inputs = has_more_inputs(*log);
  if (!more_inputs.ok()) return more_inputs.error();
  if (*more_inputs) return {};
  record_words_ = {files_.scene, "--steps", steps};
  for (const std::string& value : header.overrides) record_words_.insert(record_words_.end(), {"--set", value});
  const std::vector<std::string> transform = transform_words(header.transform);
  record_words_.insert(record_words_.end(), transform.begin(), transform.end());
  return {};
}

std::string Recording::program() const {
  return kept_.empty() ? (fs::path(place_.source()) / settings_.program).string() : kept_;
}

golden::EngineProject Recording::engine() const {
  const fs::path folder = (fs::path(place_.source()) / settings_.engine_folder).lexically_normal();
  golden::EngineProject project = golden::project_of_command(settings_.run, folder, settings_.shell);
  project.build = settings_.build;
  project.scene = settings_.engine_scene;
  project.table = settings_.engine_table;
  return project;
}

Result<Recording::Command> Recording::command(const std::string& session) const {
  if (!settings_.case_name.empty()) return case_command(session);
  Command command;
  command.folder = place_.source();
  if (settings_.run.empty()) {
    command.words = {program(), "record", "--quiet", "-o", session};
    command.words.insert(command.words.end(), record_words_.begin(), record_words_.end());
    return command;
  }
  const golden::EngineProject project = engine();
  golden::RunFiles files = files_;
  files.log = session;
  if (files.scene.empty() && !project.scene.empty()) files.scene = (project.folder / project.scene).string();
  Result<std::vector<std::string>> words = golden::engine_words(project, project.run, files);
  if (!words.ok()) return words.error();
  return Command{*std::move(words), project.folder.string()};
}

golden::CaseFolder Recording::case_folder() const {
  return {settings_.case_name, fs::path(suite()) / "cases" / settings_.case_name};
}

bool Recording::runs_engine() const {
  if (settings_.case_name.empty()) return false;
  const Result<golden::CaseRules> rules = golden::read_rules(case_folder().file(golden::kRulesFile));
  return rules.ok() && rules->is_external();
}

/// The case's own engine where it has one: a session of another engine is not that of our physics.
Result<Recording::Command> Recording::case_command(const std::string& session) const {
  const golden::CaseFolder folder = case_folder();
  const Result<golden::CaseRules> rules = golden::read_rules(folder.file(golden::kRulesFile));
  if (!rules.ok()) return rules.error();
  if (!rules->is_external()) {
    return Command{{program(), "record", "--quiet", "-o", session, folder.file(golden::kSceneFile).string()},
                   place_.source()};
  }
  Result<golden::CaseEngine> engine = golden::engine_of_case(folder, *rules, suite());
  if (!engine.ok()) return engine.error();
  engine->files.log = session;
  Result<std::vector<std::string>> words = golden::engine_words(engine->project, engine->project.run, engine->files);
  if (!words.ok()) return words.error();
  return Command{*std::move(words), engine->project.folder.string()};
}

Status Recording::make_log(const std::string& session) const {
  const std::string converted = session + ".converted";
  std::error_code error;
  Result<golden::SessionLog> log = cannot_finish("");
  if (settings_.log.empty()) {
    log = golden::log_of_session(session, converted, nullptr);
  } else {
    Result<replay::LogReader> like = open_log(settings_.log);
    if (!like.ok()) return like.error();
    log = golden::log_of_session(session, converted, &*like);
  }
  if (!log.ok()) return log.error();
  if (!log->refused.empty()) return cannot_finish(log->refused);
  if (!log->unfinished.empty()) return cannot_finish(log->unfinished);
  if (log->path != session) fs::rename(log->path, session, error);
  return error ? Status(cannot_finish(session + ": cannot be replaced: " + error.message())) : Status();
}

}  // namespace tumble::tools::bisect
