#include "tools/engine/engine_session.h"

#include <string_view>
#include <system_error>
#include <utility>

#include "golden/engine/engine_run.h"
#include "golden/engine/inputs_file.h"
#include "golden/engine/session_file.h"
#include "golden/suite/text_files.h"
#include "src/process/interrupt.h"
#include "tools/output/text.h"

namespace tumble::tools {
namespace {

namespace fs = std::filesystem;

std::string absolute(const std::string& path) {
  std::error_code error;
  return path.empty() ? "" : fs::absolute(path, error).lexically_normal().string();
}

/// The scene and the inputs of the log as files for the engine.
Result<golden::RunFiles> files_for(replay::LogReader& log, const golden::EngineProject& project,
                                   const EngineSessionOptions& options, const fs::path& folder) {
  golden::RunFiles files;
  files.log = (folder / "session").string();
  files.inputs = (folder / "inputs.jsonl").string();
  const Result<std::string> inputs = golden::inputs_text(log);
  if (!inputs.ok()) return inputs.error();
  if (Status ok = golden::write_file(files.inputs, std::string_view(*inputs)); !ok.ok()) return ok.error();
  files.scene = absolute(options.scene);
  const std::string& text = log.header().scene_text;
  if (files.scene.empty() && !text.empty()) {
    files.scene = (folder / "scene.toml").string();
    if (Status ok = golden::write_file(files.scene, std::string_view(text)); !ok.ok()) return ok.error();
  }
  if (files.scene.empty() && !project.scene.empty()) files.scene = (project.folder / project.scene).string();
  files.no_scene = "the log holds no scene text, [engine] has no key scene, and no --scene was given";
  return files;
}

}  // namespace

Result<golden::EngineProject> project_for(const replay::LogReader& log) {
  Result<std::optional<golden::EngineProject>> found = golden::find_project(".");
  if (!found.ok()) return found.error();
  if (*found) return **std::move(found);
  return bad_input(printable(log.name()) + ": this log was written by " + printable(to_string(*log.header().engine)) +
                   "; it cannot be replayed, only compared (diff, measure, dump, render, check), unless a " +
                   golden::kProjectFile +
                   " in this folder or above says how that engine runs: [engine] with run = \"… {log}\" "
                   "(docs/other_engines.md)");
}

Result<EngineSession> run_engine_session(replay::LogReader& log, const golden::EngineProject& project,
                                         const EngineSessionOptions& options, const fs::path& folder) {
  const auto interrupted = [] { return process::InterruptGuard::interrupted(); };
  Result<golden::RunFiles> files = files_for(log, project, options, folder);
  if (!files.ok()) return files.error();
  if (!options.no_build) {
    if (Status ok = golden::build_engine(project, folder / "build.txt", interrupted); !ok.ok()) return ok.error();
  }
  golden::RunPlace place = {folder / "output.txt", {}, true, interrupted};
  if (options.probed) {
    place.environment = {{"TUMBLE_PROBE_FILE", options.probed->file},
                         {"TUMBLE_PROBE_STEP", std::to_string(options.probed->step)}};
  }
  EngineSession session;
  session.gets_inputs = project.run.find("{inputs}") != std::string::npos;
  const Result<std::vector<std::string>> words = golden::engine_words(project, project.run, *files);
  if (words.ok()) session.command = golden::engine_words_text(*words);
  golden::EngineProject run = project;
  if (options.timeout_s > 0) run.timeout_s = options.timeout_s;
  const std::string converted = (folder / "converted.tumble").string();
  if (options.watch != nullptr) {
    options.watch->begin(files->log, (folder / "so_far.tumble").string(), project);
    place.cancel = [&] { return process::InterruptGuard::interrupted() || options.watch->look(); };
  }
  const Status ran = golden::run_project(run, run.run, *files, place);
  if (!ran.ok()) {
    const bool has_steps = options.watch != nullptr && !process::InterruptGuard::interrupted() &&
                           ran.error().kind == ErrorKind::kCannotFinish &&
                           (options.watch->look_once() || options.watch->wants_stop());
    if (!has_steps) return ran.error();
    session.log = options.watch->log_so_far();
    session.stopped = options.watch->wants_stop();
    session.failure = session.stopped ? "stopped at the first difference" : ran.error().message;
    return session;
  }
  Result<golden::SessionLog> made = golden::log_of_session(files->log, converted, &log);
  const std::string who =
      (project.file.empty() ? "" : project.file.string() + ": ") + "the engine's command \"" + project.run + "\" ";
  if (!made.ok()) {
    // What the engine wrote and nobody can read is the engine's failure, and no slip of the command line.
    const ErrorKind kind = made.error().kind == ErrorKind::kBadInput ? ErrorKind::kCannotFinish : made.error().kind;
    return Error{kind, who + made.error().message + golden::end_of_output(place.output)};
  }
  if (!made->refused.empty()) session.failure = who + made->refused + golden::end_of_output(place.output);
  session.log = std::move(made->path);
  session.warnings = std::move(made->warnings);
  session.unfinished = std::move(made->unfinished);
  return session;
}

}  // namespace tumble::tools
