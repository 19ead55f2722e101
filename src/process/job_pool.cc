#include "tumble/process/job_pool.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <iostream>
#include <utility>
#include <vector>

#include "src/base/check.h"
#include "src/process/child.h"
#include "src/process/parent_death.h"

namespace tumble::process {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kPollMs = 200;
constexpr char kFinished = '\x06';  // after a job's output: without it the output is cut off
constexpr int kThrew = 97;          // exit status of a child whose job threw

struct Child {
  std::size_t job = 0;
  pid_t pid = -1;
  int pipe = -1;
  Clock::time_point begin;
  JobResult result;
};

/// Runs in the child. Never returns, and runs no destructor or exit handler of the parent's.
[[noreturn]] void run_in_child(std::size_t index, const std::function<std::string(std::size_t)>& job, int out,
                               unsigned cpu_s, pid_t parent) {
  ::setpgid(0, 0);
  const rlimit no_core = {0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  const rlimit time = {cpu_s, cpu_s + 1};
  if (cpu_s > 0) ::setrlimit(RLIMIT_CPU, &time);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(number, SIG_DFL);
  end_group_with_parent(parent);
  int status = 0;
  try {
    const std::string output = job(index) + kFinished;
    if (!write_all(out, output.data(), output.size())) status = kThrew;
  } catch (const std::exception&) {
    status = kThrew;
  }
  ::_exit(status);
}

/// Children hand over their results through pipes. A child writes kFinished after its output, so that a child that dies
/// in the middle of a write is told from one that is done: an exit status of 0 alone would not do, for a job can call
/// exit() itself. Each child leads a process group, so that programs it started end with it.
class Pool {
 public:
  Pool(const std::function<std::string(std::size_t)>& job,
       const std::function<void(std::size_t, const JobResult&)>& done, const PoolOptions& options)
      : job_(job), done_(done), options_(options) {}

  bool run(std::size_t count) {
    std::size_t next = 0;
    while (next < count || !children_.empty()) {
      while (next < count && children_.size() < std::max<std::size_t>(options_.jobs, 1)) start(next++);
      wait_for_output();
      if (options_.cancel && options_.cancel()) {
        end_all();
        return false;
      }
    }
    return true;
  }

 private:
  void start(std::size_t index) {
    Child child;
    child.job = index;
    child.begin = Clock::now();
    std::array<int, 2> ends = {-1, -1};
    std::cout.flush();
    const pid_t parent = ::getpid();
    if (::pipe2(ends.data(), O_CLOEXEC) == 0) {
      child.pid = ::fork();
      if (child.pid == 0) {
        ::close(ends[0]);
        run_in_child(index, job_, ends[1], options_.cpu_s, parent);
      }
      ::close(ends[1]);
      child.pipe = ends[0];
    }
    if (child.pid < 0) {
      if (child.pipe >= 0) ::close(child.pipe);
      child.result.failure = std::string("no process could be started: ") + std::strerror(errno);
      done_(index, child.result);
      return;
    }
    ::setpgid(child.pid, child.pid);  // also in the child: whoever comes first
    children_.push_back(std::move(child));
  }

  void wait_for_output() {
    std::vector<pollfd> files;
    for (const Child& child : children_) files.push_back({child.pipe, POLLIN, 0});
    if (files.empty()) return;
    ::poll(files.data(), files.size(), kPollMs);
    for (std::size_t i = children_.size(); i-- > 0;) {
      Child& child = children_[i];
      const bool over = files[i].revents != 0 && read_some(child);
      const double seconds = std::chrono::duration<double>(Clock::now() - child.begin).count();
      const bool late = !over && seconds > options_.timeout_s;
      if (!over && !late) continue;
      finish(child, late);
      const Child ended = std::move(child);
      children_.erase(children_.begin() + static_cast<std::ptrdiff_t>(i));
      done_(ended.job, ended.result);
    }
  }

  /// True at the end of the child's output.
  static bool read_some(Child& child) {
    std::array<char, 65536> block;
    const ssize_t got = ::read(child.pipe, block.data(), block.size());
    if (got < 0) return errno != EINTR && errno != EAGAIN;
    child.result.output.append(block.data(), static_cast<std::size_t>(got));
    return got == 0;
  }

  void finish(Child& child, bool late) const {
    if (late) signal_group(child.pid, SIGKILL);
    ::close(child.pipe);
    const ChildEnd end = wait_for_group(child.pid);
    JobResult& result = child.result;
    result.seconds = std::chrono::duration<double>(Clock::now() - child.begin).count();
    const bool whole = result.output.ends_with(kFinished);
    if (whole) result.output.pop_back();
    if (late) {
      result.failure = "took longer than " + std::to_string(static_cast<long>(options_.timeout_s)) + " s";
    } else if (end.signal == SIGXCPU) {
      result.failure = "took longer than " + std::to_string(options_.cpu_s) + " s of processor time";
    } else if (end.signal != 0) {
      result.failure = "ended by " + signal_name(end.signal);
    } else if (!end.well() || !whole) {
      result.failure = "ended with status " + std::to_string(end.exit) + " before it was done";
    }
    if (!result.failure.empty()) result.output.clear();
  }

  void end_all() {
    for (const Child& child : children_) {
      signal_group(child.pid, SIGKILL);
      ::close(child.pipe);
      wait_for(child.pid);
    }
    children_.clear();
  }

  const std::function<std::string(std::size_t)>& job_;
  const std::function<void(std::size_t, const JobResult&)>& done_;
  const PoolOptions& options_;
  std::vector<Child> children_;
};

}  // namespace

bool run_jobs(std::size_t count, const std::function<std::string(std::size_t)>& job,
              const std::function<void(std::size_t, const JobResult&)>& done, const PoolOptions& options) {
  SIM_CHECK(job && done);
  return Pool(job, done, options).run(count);
}

}  // namespace tumble::process
