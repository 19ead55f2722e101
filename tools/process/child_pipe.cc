#include "tools/process/child_pipe.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

extern char** environ;  // NOLINT: POSIX asks for this declaration

namespace tumble::tools {
namespace {

// Starts `words` with `input` as its standard input; 0 or an errno.
int spawn(std::vector<std::string> words, int input, pid_t& child) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  // Ctrl-C is for us alone: the program ends when its input does.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int error = posix_spawnp(&child, argv[0], &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

}  // namespace

Status ChildPipe::start(std::vector<std::string> words, const std::string& purpose, const std::string& package) {
  const std::string program = words.front();
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return cannot_finish("no pipe to " + program + ": " + std::strerror(errno));
  const int error = spawn(std::move(words), ends[0], child_);
  close(ends[0]);
  pipe_ = ends[1];
  if (error == 0) {
    std::signal(SIGPIPE, SIG_IGN);  // a program that ends early is an error of write(), not our end
    return {};
  }
  child_ = -1;
  if (error == ENOENT) {
    return cannot_finish(purpose + " need " + program + ", which is not installed (Debian: apt-get install " + package +
                         ")");
  }
  return cannot_finish(program + " cannot be started: " + std::strerror(error));
}

bool ChildPipe::write(std::span<const std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t written = ::write(pipe_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

bool ChildPipe::finish() {
  if (pipe_ >= 0) close(pipe_);
  pipe_ = -1;
  int status = -1;
  if (child_ > 0) {
    while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
  }
  child_ = -1;
  return status == 0;
}

void ChildPipe::abandon() {
  if (child_ > 0) kill(child_, SIGTERM);
  static_cast<void>(finish());
}

}  // namespace tumble::tools
