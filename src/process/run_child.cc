#include "src/process/run_child.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <string>
#include <thread>

#include "src/process/parent_death.h"

namespace tumble::process {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

void send(const Program& program, pid_t child, int number) {
  if (program.own_group) {
    signal_group(child, number);
  } else {
    ::kill(child, number);
  }
}

ChildEnd wait_until(const Program& program, pid_t child, double timeout_s, const Cancel& cancel) {
  bool stopped = false, late = false;
  auto pause = 1ms;
  const auto begin = Clock::now();
  auto kill_at = Clock::time_point::max();
  ChildEnd end;
  while (!has_ended(child, end)) {
    const auto now = Clock::now();
    if (!stopped && !late) {
      stopped = cancel && cancel();
      late = !stopped && timeout_s > 0 && std::chrono::duration<double>(now - begin).count() > timeout_s;
      if (stopped || late) {
        send(program, child, SIGTERM);
        kill_at = now + 5s;
      }
    } else if (now > kill_at) {
      send(program, child, SIGKILL);
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, 50ms);
  }
  end.stopped = stopped;
  end.late = late;
  return end;
}

}  // namespace

Result<ChildEnd> run_child(const Program& program, double timeout_s, const Cancel& cancel) {
  for (const std::string& file : {program.out, program.err}) {
    if (file.empty()) continue;
    const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (opened < 0) return cannot_finish(file + ": cannot be written: " + std::strerror(errno));
    ::close(opened);
  }
  pid_t child = -1;
  if (const int error = start(program, child); error != 0) {
    return cannot_finish(program.words[0] + " cannot be started: " + std::strerror(error));
  }
  std::optional<GroupGuard> guard;  // without a group of its own it ends with ours
  if (program.own_group) guard.emplace(child);
  return wait_until(program, child, timeout_s, cancel);
}

}  // namespace tumble::process
