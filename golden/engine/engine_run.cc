#include "golden/engine/engine_run.h"

#include <algorithm>
#include <system_error>

#include "golden/suite/text_files.h"
#include "src/base/text.h"
#include "src/base/utf8.h"
#include "src/process/split_words.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kOutputShown = 500;  // bytes

/// One pass, so that a path with a placeholder's name in it stays as it is.
template <class Quote>
std::string filled(const std::string& text, const RunFiles& files, const Quote& quote) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const auto take = [&](std::string_view name, const std::string& value) {
      if (text.compare(at, name.size(), name) != 0) return false;
      out += quote(value);
      at += name.size();
      return true;
    };
    if (take("{scene}", files.scene) || take("{inputs}", files.inputs) || take("{log}", files.log)) continue;
    out += text[at++];
  }
  return out;
}

std::string who(const EngineProject& project, const char* what, const std::string& command) {
  return (project.file.empty() ? "" : project.file.string() + ": ") + what + " \"" + command + "\" ";
}

Status outcome(const Result<process::ChildEnd>& end, bool shell, const std::string& about, const fs::path& output) {
  if (!end.ok()) return cannot_finish(about + "was not run: " + end.error().message);
  if (end->stopped) return cannot_finish("interrupted");
  if (end->well()) return {};
  const process::ChildEnd known = shell ? process::behind_shell(*end) : *end;
  return cannot_finish(about + known.text() + end_of_output(output));
}

}  // namespace

std::string end_of_output(const fs::path& file) {
  const Result<std::string> text = read_text(file);
  if (!text.ok() || text->empty()) return "";
  std::string end = valid_text(text->substr(text->size() - std::min(text->size(), kOutputShown)));
  end.erase(end.find_last_not_of(" \t\r\n") + 1);
  return end.empty() ? "" : "; it printed: " + end;
}

Result<std::vector<std::string>> engine_words(const EngineProject& project, const std::string& command,
                                              const RunFiles& files) {
  if (files.scene.empty() && command.find("{scene}") != std::string::npos) {
    return bad_input((project.file.empty() ? "" : project.file.string() + ": ") + "run: found {scene}, and " +
                     (files.no_scene.empty() ? "there is no scene to put there" : files.no_scene) +
                     "; name one, or leave {scene} out");
  }
  if (project.shell) {
    return std::vector<std::string>{"sh", "-c", filled(command, files, shell_quoted)};
  }
  Result<std::vector<std::string>> words = process::split_words(command);
  if (!words.ok()) return words.error();
  for (std::string& word : *words) word = filled(word, files, [](const std::string& path) { return path; });
  return words;
}

std::string engine_words_text(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + shell_quoted(word);
  return text;
}

Status build_engine(const EngineProject& project, const fs::path& output, const process::Cancel& cancel) {
  for (const std::string& command : project.build) {
    const Result<std::vector<std::string>> words = engine_words(project, command, {});
    if (!words.ok()) return words.error();
    process::Program task;
    task.words = *words;
    task.folder = project.folder.string();
    task.out = task.err = output.string();
    Status built =
        outcome(process::run_child(task, 0, cancel), project.shell, who(project, "the build command", command), output);
    if (!built.ok()) return built;
  }
  return {};
}

Status run_project(const EngineProject& project, const std::string& command, const RunFiles& files,
                   const RunPlace& place) {
  const Result<std::vector<std::string>> words = engine_words(project, command, files);
  if (!words.ok()) return words.error();
  process::Program task;
  task.words = *words;
  task.folder = project.folder.string();
  task.out = task.err = place.output.string();
  task.set = place.environment;
  task.own_group = place.own_group;
  const std::string about = who(project, "the engine's command", command);
  Status ran = outcome(process::run_child(task, project.timeout_s, place.cancel), project.shell, about, place.output);
  if (!ran.ok()) return ran;
  if (Status read = rewrite_table(files.log, project.table, project.folder); !read.ok()) {
    return Error{read.error().kind, about + "wrote a table: " + read.error().message};
  }
  return {};
}

}  // namespace tumble::golden
