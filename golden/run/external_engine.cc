#include "golden/run/external_engine.h"

#include <chrono>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "golden/engine/session_file.h"
#include "golden/suite/temporary_folder.h"
#include "golden/suite/text_files.h"
#include "src/base/check.h"
#include "src/base/text.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLogMark = "\x01";  // stands for the log in a line, where no path has it

std::string full_path(const fs::path& path) {
  std::error_code error;
  return fs::absolute(path, error).lexically_normal().string();
}

/// A path from the engine's folder, where that is shorter.
std::string from_folder(const std::string& path, const fs::path& folder) {
  if (path.empty()) return path;
  const std::string relative = fs::path(path).lexically_relative(folder).string();
  return relative.empty() || relative.starts_with("../..") ? path : relative;
}

/// The steps that an engine wrote before it failed; the failure itself where there is none.
Result<Session> session_before(const Error& failure, const RunFiles& files, const std::string& converted,
                               const EngineProject& project, double seconds) {
  if (failure.kind != ErrorKind::kCannotFinish) return failure;
  const std::optional<std::string> log = log_so_far(files.log, converted, nullptr, project);
  if (!log) return failure;
  Result<std::vector<std::byte>> bytes = read_bytes(*log);
  if (!bytes.ok()) return failure;
  Session session{std::make_shared<std::vector<std::byte>>(*std::move(bytes)), {}, failure.message, seconds, true};
  const Result<replay::LogReader> reader = open_session(session, *log);
  if (!reader.ok() || reader->step_count() == 0) return failure;
  session.was_converted = *log == converted;
  return session;
}

constexpr const char* kRecordedEnding = ".recorded";

/// The command that makes NAME.tumble of what the engine wrote.
std::string import_line(const CaseEngine& engine, const std::string& name) {
  const TableReading& table = engine.project.table;
  const auto file = [&](const std::string& path) { return shell_quoted((engine.project.folder / path).string()); };
  std::string line = "tumble import " + shell_quoted(name + kRecordedEnding) + " -o " + shell_quoted(name + ".tumble");
  for (const std::string& one : table.header) line += " --header " + shell_quoted(one);
  for (const std::string& one : table.map) line += " --map " + shell_quoted(one);
  if (!table.map_file.empty()) line += " --map-file " + file(table.map_file);
  if (!table.model.empty()) line += " --model " + file(table.model);
  return line + (table.scalar_last ? " --scalar-last" : "") + (table.channels ? " --channels" : "");
}

}  // namespace

std::string suite_option(const fs::path& suite) {
  return suite == "golden" ? "" : " --suite " + shell_quoted(suite.string());
}

Result<CaseEngine> engine_of_case(const CaseFolder& folder, const CaseRules& rules, const fs::path& suite) {
  SIM_CHECK(rules.is_external());
  CaseEngine engine;
  if (!rules.engine) {
    engine.project = project_of_command(rules.command, full_path(suite), true);
    engine.files.scene = full_path(folder.file(kSceneFile));
    return engine;
  }
  Result<std::optional<EngineProject>> project = find_project(suite);
  if (!project.ok()) return project.error();
  if (!*project) {
    return bad_input(folder.file(kRulesFile).string() + ": [engine]: found no " + kProjectFile + " in " +
                     full_path(suite) + " or above, wanted one that says how the engine runs");
  }
  engine.project = **std::move(project);
  const auto file = [&](const std::string& name) { return name.empty() ? "" : full_path(folder.path / name); };
  engine.files.scene = file(rules.engine->scene);
  if (engine.files.scene.empty() && !engine.project.scene.empty()) {
    engine.files.scene = full_path(engine.project.folder / engine.project.scene);
  }
  engine.files.inputs = rules.engine->inputs.empty() ? "/dev/null" : file(rules.engine->inputs);
  engine.files.no_scene = "the case's [engine] names no scene";
  return engine;
}

std::string engine_line(const CaseEngine& engine, const std::string& name, bool converts) {
  const fs::path& folder = engine.project.folder;
  RunFiles files = engine.files;
  files.scene = from_folder(files.scene, folder);
  files.inputs = from_folder(files.inputs, folder);
  files.log = kLogMark;
  const Result<std::vector<std::string>> words = engine_words(engine.project, engine.project.run, files);
  if (!words.ok()) return "";
  const std::string line = engine.project.shell ? words->back() : engine_words_text(*words);
  // The mark stands in single quotes: they end before the variable and begin again behind it.
  const std::string written = shell_quoted(name + (converts ? kRecordedEnding : ".tumble"));
  std::error_code error;
  const fs::path here = fs::current_path(error);
  const std::string place = from_folder(folder.string(), here);
  const bool is_here = place == ".";
  const std::string log = replaced(line, kLogMark, (is_here ? "'" : "'\"$OLDPWD\"/") + written + "'");
  const std::string command = replaced(log, "''", "");
  const std::string runs = is_here ? command : "(cd " + shell_quoted(place) + " && " + command + ")";
  return converts ? runs + "; " + import_line(engine, name) : runs;  // also of an engine that fails
}

Result<Session> run_engine(const CaseEngine& engine, const fs::path& scratch) {
  const TemporaryFolder folder("tumble-engine", scratch);
  if (folder.path().empty()) return cannot_finish("no temporary folder for an engine's log");
  RunFiles files = engine.files;
  files.log = (folder.path() / "session.tumble").string();
  RunPlace place;
  place.output = folder.path() / "output.txt";
  place.own_group = false;  // a case that takes too long is ended as a group, and the engine with it
  const auto begin = std::chrono::steady_clock::now();
  const Status ran = run_project(engine.project, engine.project.run, files, place);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const std::string converted = (folder.path() / "converted.tumble").string();
  if (!ran.ok()) return session_before(ran.error(), files, converted, engine.project, seconds);
  const std::string who = "the engine's command \"" + engine.project.run + "\" ";
  // `import` of the same table prints its warnings.
  const Result<SessionLog> log = log_of_session(files.log, converted, nullptr);
  if (!log.ok()) return cannot_finish(who + log.error().message + end_of_output(place.output));
  Result<std::vector<std::byte>> bytes = read_bytes(log->path);
  if (!bytes.ok()) return cannot_finish(who + "wrote no log that can be read: " + bytes.error().message);
  const std::string failure = !log->refused.empty()      ? who + log->refused
                              : !log->unfinished.empty() ? who + "ended well, but " + log->unfinished
                                                         : "";
  Session session{std::make_shared<std::vector<std::byte>>(*std::move(bytes)), {}, failure, seconds};
  session.was_converted = log->path == converted;
  session.cut_short = !log->refused.empty();
  return session;
}

Status build_engine_of(const std::vector<CaseFolder>& cases, const fs::path& suite, const process::Cancel& cancel) {
  for (const CaseFolder& folder : cases) {
    std::optional<EngineCase> own = engine_case(folder);
    if (!own) continue;
    CaseRules rules;
    rules.engine = std::move(own);
    const Result<CaseEngine> engine = engine_of_case(folder, rules, suite);
    if (!engine.ok()) return engine.error();
    const TemporaryFolder place("tumble-engine");
    if (place.path().empty()) return cannot_finish("no temporary folder for an engine's build");
    return build_engine(engine->project, place.path() / "build.txt", cancel);
  }
  return {};
}

}  // namespace tumble::golden
