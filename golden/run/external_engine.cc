#include "golden/run/external_engine.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <system_error>

#include "golden/suite/temporary_folder.h"
#include "golden/suite/text_files.h"
#include "src/process/run_child.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kOutputShown = 500;  // bytes

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
  return text;
}

/// The command line with the shell's words for {scene} and {log} in it.
std::string filled(const std::string& command, const std::string& scene, const std::string& log) {
  return replaced(replaced(command, "{scene}", scene), "{log}", log);
}

std::string end_of(const fs::path& file) {
  const Result<std::string> text = read_text(file);
  if (!text.ok() || text->empty()) return "";
  return "; it printed: " + text->substr(text->size() - std::min(text->size(), kOutputShown));
}

}  // namespace

std::string shell_quoted(const std::string& word) {
  const bool plain = !word.empty() && word.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_-./+=:,@") == std::string::npos;
  return plain ? word : "'" + replaced(word, "'", "'\\''") + "'";
}

std::string suite_option(const fs::path& suite) {
  return suite == "golden" ? "" : " --suite " + shell_quoted(suite.string());
}

std::string engine_command(const std::string& command, const std::string& scene, const std::string& log) {
  return filled(command, shell_quoted(scene), shell_quoted(log));
}

std::string engine_line(const std::string& command, const fs::path& suite, const CaseFolder& folder) {
  const fs::path scene = folder.file(kSceneFile).lexically_relative(suite);
  const std::string log = "\"$OLDPWD\"/" + shell_quoted(folder.name + ".tumble");
  return "(cd " + shell_quoted(suite.string()) + " && " + filled(command, shell_quoted(scene.string()), log) + ")";
}

Result<Session> run_engine(const std::string& command, const fs::path& suite, const std::string& scene,
                           const fs::path& scratch) {
  const TemporaryFolder folder("tumble-engine", scratch);
  if (folder.path().empty()) return cannot_finish("no temporary folder for an engine's log");
  const fs::path log = folder.path() / "session.tumble";
  const fs::path output = folder.path() / "output.txt";
  std::error_code error;
  process::Program shell;
  shell.words = {"sh", "-c", engine_command(command, fs::absolute(scene, error).string(), log.string())};
  shell.folder = suite.string();
  shell.out = shell.err = output.string();
  shell.own_group = false;  // a case that takes too long is ended as a group, and the engine with it
  const std::string who = "the engine's command \"" + command + "\" ";
  const auto begin = std::chrono::steady_clock::now();
  const Result<process::ChildEnd> end = process::run_child(shell);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!end.ok()) return cannot_finish(who + "was not run: " + end.error().message);
  if (!end->well()) return cannot_finish(who + process::behind_shell(*end).text() + end_of(output));
  Result<std::vector<std::byte>> bytes = read_bytes(log);
  if (!bytes.ok()) return cannot_finish(who + "wrote no log" + end_of(output));
  return Session{std::make_shared<std::vector<std::byte>>(*std::move(bytes)), {}, {}, seconds};
}

}  // namespace tumble::golden
