#include "tools/process/child_run.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

extern char** environ;  // NOLINT: POSIX asks for this declaration

namespace tumble::tools {
namespace {

using namespace std::chrono_literals;

constexpr std::array kGitsOwn = {"GIT_DIR=",
                                 "GIT_WORK_TREE=",
                                 "GIT_INDEX_FILE=",
                                 "GIT_PREFIX=",
                                 "GIT_OBJECT_DIRECTORY=",
                                 "GIT_COMMON_DIR=",
                                 "GIT_NAMESPACE=",
                                 "GIT_ALTERNATE_OBJECT_DIRECTORIES="};

std::vector<std::string> environment_with(const std::map<std::string, std::string>& more) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (std::ranges::none_of(kGitsOwn, [&](const char* name) { return text.starts_with(name); })) all.push_back(text);
  }
  for (const auto& setting : more) {
    const std::string start = setting.first + '=';
    const bool has = std::ranges::any_of(all, [&](const std::string& text) { return text.starts_with(start); });
    if (!has) all.push_back(start + setting.second);
  }
  return all;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> all;
  all.reserve(texts.size() + 1);
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

/// 0 or an errno.
int spawn(const ChildTask& task, pid_t& child) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  constexpr int kCreate = O_WRONLY | O_CREAT | O_APPEND;
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, task.out.c_str(), kCreate, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, task.err.c_str(), kCreate, 0600);
  if (!task.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, task.folder.c_str());
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);  // so that all it starts can be ended with it
  posix_spawnattr_setpgroup(&attributes, 0);
  std::vector<std::string> words = task.words, environment = environment_with(task.more);
  const int error = posix_spawnp(&child, words[0].c_str(), &actions, &attributes, pointers_to(words).data(),
                                 pointers_to(environment).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

ChildEnd wait_for(pid_t child, double timeout_s, const std::function<bool()>& cancel) {
  ChildEnd end;
  int status = 0;
  auto pause = 1ms;
  const auto begin = std::chrono::steady_clock::now();
  auto kill_at = std::chrono::steady_clock::time_point::max();
  const auto too_long = [&] {
    return timeout_s > 0 && std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() > timeout_s;
  };
  while (true) {
    const pid_t found = waitpid(child, &status, WNOHANG);
    if (found == child || (found < 0 && errno != EINTR)) break;
    if (!end.stopped && !end.late) {
      end.stopped = cancel && cancel();
      end.late = !end.stopped && too_long();
      if (!end.stopped && !end.late) {
        std::this_thread::sleep_for(pause);
        pause = std::min(2 * pause, 50ms);
        continue;
      }
      kill(-child, SIGTERM);
      kill_at = std::chrono::steady_clock::now() + 5s;
    }
    if (std::chrono::steady_clock::now() > kill_at) kill(-child, SIGKILL);
    std::this_thread::sleep_for(pause);
  }
  if (WIFEXITED(status)) end.exit = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  return end;
}

}  // namespace

std::string ChildEnd::text() const {
  if (late) return "took too long";
  if (signal == 0) return "ended with status " + std::to_string(exit);
  const char* name = sigabbrev_np(signal);
  return "was ended by " + (name != nullptr ? "SIG" + std::string(name) : "signal " + std::to_string(signal));
}

Result<ChildEnd> run_child(const ChildTask& task, const std::function<bool()>& cancel) {
  for (const std::string& file : {task.out, task.err}) {
    const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (opened < 0) return cannot_finish(file + ": cannot be written: " + std::strerror(errno));
    close(opened);
  }
  pid_t child = -1;
  if (const int error = spawn(task, child); error != 0) {
    return cannot_finish(task.words[0] + " cannot be started: " + std::strerror(error));
  }
  return wait_for(child, task.timeout_s, cancel);
}

Result<std::vector<std::string>> split_words(const std::string& command) {
  std::vector<std::string> words;
  std::string word;
  bool in_word = false;
  char quote = 0;
  for (std::size_t i = 0; i < command.size(); ++i) {
    const char c = command[i];
    if (c == '\\' && quote != '\'' && i + 1 < command.size()) {
      word += command[++i];
      in_word = true;
    } else if (quote != 0) {
      if (c == quote) {
        quote = 0;
      } else {
        word += c;
      }
    } else if (c == '\'' || c == '"') {
      quote = c;
      in_word = true;
    } else if (c == ' ' || c == '\t') {
      if (in_word) words.push_back(std::exchange(word, ""));
      in_word = false;
    } else {
      word += c;
      in_word = true;
    }
  }
  if (quote != 0) return bad_input("found a quote without its end in: " + command);
  if (in_word) words.push_back(word);
  if (words.empty()) return bad_input("found no word in the command");
  return words;
}

}  // namespace tumble::tools
