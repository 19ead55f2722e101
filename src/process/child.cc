#include "src/process/child.h"

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

#include "src/base/check.h"

extern char** environ;  // NOLINT: POSIX asks for this declaration

namespace tumble::process {
namespace {

constexpr int kBusyTries = 200;
constexpr std::chrono::milliseconds kBusyPause{10};
constexpr int kShellSignals = 128;  // a shell's status for a command that signal n ended is this and n

// A hook of git's runs us with these set; a git that we start would then work on the hook's repository.
constexpr std::array kGitsOwn = {"GIT_DIR=",
                                 "GIT_WORK_TREE=",
                                 "GIT_INDEX_FILE=",
                                 "GIT_PREFIX=",
                                 "GIT_OBJECT_DIRECTORY=",
                                 "GIT_COMMON_DIR=",
                                 "GIT_NAMESPACE=",
                                 "GIT_ALTERNATE_OBJECT_DIRECTORIES="};

std::vector<std::string> environment_of(const Program& program) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (program.set.contains(text.substr(0, text.find('=')))) continue;
    if (std::ranges::none_of(kGitsOwn, [&](const char* name) { return text.starts_with(name); })) all.push_back(text);
  }
  for (const auto& [name, value] : program.set) all.push_back(std::string(name).append("=").append(value));
  for (const auto& setting : program.more) {
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

ChildEnd end_of(int status) {
  ChildEnd end;
  if (WIFEXITED(status)) end.exit = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  return end;
}

/// Files and folder of a program as posix_spawn takes them; freed with this.
class Surroundings {
 public:
  explicit Surroundings(const Program& program) {
    posix_spawn_file_actions_init(&actions_);
    if (program.in < 0) posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (program.in >= 0) posix_spawn_file_actions_adddup2(&actions_, program.in, STDIN_FILENO);
    add_to(program.out, STDOUT_FILENO);
    add_to(program.err, STDERR_FILENO);
    if (!program.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions_, program.folder.c_str());
    posix_spawnattr_init(&attributes_);
    if (!program.own_group) return;
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes_, 0);
  }
  ~Surroundings() {
    posix_spawnattr_destroy(&attributes_);
    posix_spawn_file_actions_destroy(&actions_);
  }
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

  [[nodiscard]] const posix_spawn_file_actions_t* actions() const { return &actions_; }
  [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  void add_to(const std::string& file, int descriptor) {
    constexpr int kAppend = O_WRONLY | O_CREAT | O_APPEND;
    if (!file.empty()) posix_spawn_file_actions_addopen(&actions_, descriptor, file.c_str(), kAppend, 0600);
  }

  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

}  // namespace

std::string signal_name(int number) {
  const char* name = ::sigabbrev_np(number);
  return name == nullptr ? "signal " + std::to_string(number) : "SIG" + std::string(name);
}

std::string ChildEnd::text() const {
  if (late) return "took too long";
  return signal == 0 ? "ended with status " + std::to_string(exit) : "was ended by " + signal_name(signal);
}

ChildEnd behind_shell(ChildEnd end) {
  if (end.exit <= kShellSignals || ::sigabbrev_np(end.exit - kShellSignals) == nullptr) return end;
  end.signal = end.exit - kShellSignals;
  end.exit = -1;
  return end;
}

int start(const Program& program, pid_t& child) {
  SIM_CHECK(!program.words.empty());
  const Surroundings surroundings(program);
  std::vector<std::string> words = program.words, environment = environment_of(program);
  const auto spawn = [&] {
    return posix_spawnp(&child, words[0].c_str(), surroundings.actions(), surroundings.attributes(),
                        pointers_to(words).data(), pointers_to(environment).data());
  };
  int failed = spawn();
  // A program that was written a moment ago is busy until a child that another thread has just forked has become the
  // program that it starts: until then that child holds the file open as well.
  for (int k = 0; failed == ETXTBSY && k < kBusyTries; ++k) {
    std::this_thread::sleep_for(kBusyPause);
    failed = spawn();
  }
  return failed;
}

ChildEnd wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return {};
  }
  return end_of(status);
}

bool has_ended(pid_t child, ChildEnd& end) {
  int status = 0;
  const pid_t found = ::waitpid(child, &status, WNOHANG);
  if (found != child && (found == 0 || errno == EINTR)) return false;
  end = found == child ? end_of(status) : ChildEnd();
  return true;
}

ChildEnd wait_for_group(pid_t child) {
  siginfo_t info = {};
  while (::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
  }
  signal_group(child, SIGKILL);  // before the child is reaped: until then no other process can have its number
  return wait_for(child);
}

void signal_group(pid_t child, int number) {
  SIM_CHECK(child > 1, child);  // −1 and −0 would be every process, or ours
  ::kill(-child, number);
}

void end_own_group() {
  if (::getpgrp() != ::getpid()) return;
  struct sigaction ignore = {}, before = {};
  ignore.sa_handler = SIG_IGN;
  ::sigaction(SIGTERM, &ignore, &before);
  ::kill(0, SIGTERM);
  ::sigaction(SIGTERM, &before, nullptr);
}

bool write_all(int file, const char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(file, bytes, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

}  // namespace tumble::process
