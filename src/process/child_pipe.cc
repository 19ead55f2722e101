#include "src/process/child_pipe.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "src/base/check.h"
#include "src/base/text.h"
#include "src/process/child.h"

namespace tumble::process {

Status ChildPipe::start(std::vector<std::string> words, const std::string& purpose, const std::string& package,
                        const std::string& errors) {
  SIM_CHECK(!running());
  int ends[2];
  Program program;
  program.words = std::move(words);
  const std::string& name = program.words.front();
  if (::pipe2(ends, O_CLOEXEC) != 0) return cannot_finish("no pipe to " + name + ": " + std::strerror(errno));
  program.in = ends[0];
  program.err = errors;
  const int error = process::start(program, child_);
  ::close(ends[0]);
  pipe_ = ends[1];
  if (error == 0) {
    std::signal(SIGPIPE, SIG_IGN);  // a program that ends early is an error of write(), not our end
    return {};
  }
  child_ = -1;
  if (error == ENOENT) {
    return cannot_finish(purpose + " need " + name + ", which is not installed (Debian: apt-get install " + package +
                         ")");
  }
  return cannot_finish(name + " cannot be started: " + std::strerror(error));
}

bool ChildPipe::write(std::span<const std::byte> bytes) const {
  SIM_CHECK(running());
  return write_all(pipe_, reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

bool ChildPipe::finish() {
  if (pipe_ >= 0) ::close(pipe_);
  pipe_ = -1;
  const bool well = running() && wait_for(child_).well();
  child_ = -1;
  return well;
}

void ChildPipe::abandon() {
  if (running()) signal_group(child_, SIGTERM);
  static_cast<void>(finish());
}

std::string last_words(std::string_view said) {
  const std::size_t end = said.find_last_not_of(" \r\n");
  if (end == std::string_view::npos) return ", and it said nothing; is the disk full?";
  said = said.substr(0, end + 1);
  return ": " + printable(said.substr(said.find_last_of('\n') + 1));
}

}  // namespace tumble::process
