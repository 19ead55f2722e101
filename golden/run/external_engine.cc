#include "golden/run/external_engine.h"

#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <system_error>

#include "golden/suite/temporary_folder.h"
#include "golden/suite/text_files.h"

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

std::string end_of(const fs::path& file) {
  const Result<std::string> text = read_text(file);
  if (!text.ok() || text->empty()) return "";
  return "; it printed: " + text->substr(text->size() - std::min(text->size(), kOutputShown));
}

std::string ending(int status) {
  const int code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);  // sh reports its child's so
  const char* name = code > 128 ? ::sigabbrev_np(code - 128) : nullptr;
  if (name != nullptr) return "was ended by SIG" + std::string(name);
  return "ended with status " + std::to_string(code);
}

}  // namespace

std::string shell_quoted(const std::string& word) {
  const bool plain = !word.empty() && word.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_-./+=:,@") == std::string::npos;
  return plain ? word : "'" + replaced(word, "'", "'\\''") + "'";
}

std::string engine_command(const std::string& command, const std::string& scene, const std::string& log) {
  return replaced(replaced(command, "{scene}", shell_quoted(scene)), "{log}", shell_quoted(log));
}

Result<Session> run_engine(const std::string& command, const fs::path& suite, const std::string& scene) {
  const TemporaryFolder folder("tumble-engine");
  if (folder.path().empty()) return cannot_finish("no temporary folder for an engine's log");
  const fs::path log = folder.path() / "session.tumble";
  const fs::path output = folder.path() / "output.txt";
  std::error_code error;
  const std::string line = "cd " + shell_quoted(suite.string()) + " && { " +
                           engine_command(command, fs::absolute(scene, error).string(), log.string()) + "\n} >" +
                           shell_quoted(output.string()) + " 2>&1";
  const int status = std::system(line.c_str());
  const std::string who = "the engine's command \"" + command + "\" ";
  if (status != 0) return cannot_finish(who + ending(status) + end_of(output));
  Result<std::vector<std::byte>> bytes = read_bytes(log);
  if (!bytes.ok()) return cannot_finish(who + "wrote no log" + end_of(output));
  return Session{std::make_shared<std::vector<std::byte>>(*std::move(bytes)), {}, {}};
}

}  // namespace tumble::golden
