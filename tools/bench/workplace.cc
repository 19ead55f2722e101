#include "tools/bench/workplace.h"

#include <sys/resource.h>
#include <sys/wait.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>

#include "src/process/child.h"
#include "tools/bench/bench.h"

namespace tumble::tools {
namespace {

namespace fs = std::filesystem;

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

Result<ProgramRun> Workplace::run(const std::vector<std::string>& arguments) const {
  if (folder_.path().empty()) return cannot_finish("bench: no temporary folder can be made");
  process::Program program;
  std::error_code error;
  program.words = {fs::read_symlink("/proc/self/exe", error).string()};
  program.words.insert(program.words.end(), arguments.begin(), arguments.end());
  program.out = file("out");
  program.err = file("err");
  program.own_group = false;  // Ctrl-C ends it too
  fs::remove(program.err, error);
  const auto began = std::chrono::steady_clock::now();
  pid_t child = 0;
  if (const int failed = process::start(program, child); failed != 0) {
    return cannot_finish("bench: " + program.words.front() + " does not start: " + std::strerror(failed));
  }
  int status = 0;
  rusage used = {};
  while (::wait4(child, &status, 0, &used) < 0) {
    if (errno != EINTR) return cannot_finish(std::string("bench: ") + std::strerror(errno));
  }
  ProgramRun run;
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  run.exit = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  run.cpu = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  run.megabytes = static_cast<double>(used.ru_maxrss) * 1024 / 1e6;
  run.err = printed_in(program.err);
  return run;
}

}  // namespace tumble::tools
