#include "golden/run/process_pool.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <iostream>
#include <vector>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace tumble::golden {
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
  ChildResult result;
};

bool write_all(int file, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t wrote = ::write(file, text.data() + done, text.size() - done);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) return false;
    done += static_cast<std::size_t>(wrote);
  }
  return true;
}

/// In the child; never returns, and runs no destructor or exit handler of the parent's.
[[noreturn]] void live_as_child(std::size_t index, const std::function<std::string(std::size_t)>& job, int out) {
  ::setpgid(0, 0);
  const rlimit no_core = {0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  for (const int number : {SIGINT, SIGTERM, SIGPIPE}) std::signal(number, SIG_DFL);
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  int status = 0;
  try {
    const std::string output = job(index) + kFinished;
    if (!write_all(out, output)) status = kThrew;
  } catch (const std::exception&) {
    status = kThrew;
  }
  ::_exit(status);
}

std::string signal_name(int number) {
  const char* name = ::sigabbrev_np(number);
  return name == nullptr ? "signal " + std::to_string(number) : "SIG" + std::string(name);
}

class Pool {
 public:
  Pool(const std::function<std::string(std::size_t)>& job,
       const std::function<void(std::size_t, const ChildResult&)>& done, const PoolOptions& options)
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
    if (::pipe2(ends.data(), O_CLOEXEC) == 0) {
      child.pid = ::fork();
      if (child.pid == 0) {
        ::close(ends[0]);
        live_as_child(index, job_, ends[1]);
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
    // The child leads a group of its own: what it started goes with it.
    if (late) ::kill(-child.pid, SIGKILL);
    ::close(child.pipe);
    siginfo_t info = {};
    while (::waitid(P_PID, static_cast<id_t>(child.pid), &info, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
    }
    ::kill(-child.pid, SIGKILL);  // before it is reaped: nobody else can have its number yet
    int status = 0;
    ::waitpid(child.pid, &status, 0);
    ChildResult& result = child.result;
    result.seconds = std::chrono::duration<double>(Clock::now() - child.begin).count();
    const bool whole = result.output.ends_with(kFinished);
    if (whole) result.output.pop_back();
    if (late) {
      result.failure = "took longer than " + std::to_string(static_cast<long>(options_.timeout_s)) + " s";
    } else if (WIFSIGNALED(status)) {
      result.failure = "ended by " + signal_name(WTERMSIG(status));
    } else if (WEXITSTATUS(status) != 0 || !whole) {
      result.failure = "ended with status " + std::to_string(WEXITSTATUS(status)) + " before it was done";
    }
    if (!result.failure.empty()) result.output.clear();
  }

  void end_all() {
    for (Child& child : children_) {
      ::kill(-child.pid, SIGKILL);
      ::close(child.pipe);
      int status = 0;
      ::waitpid(child.pid, &status, 0);
    }
    children_.clear();
  }

  const std::function<std::string(std::size_t)>& job_;
  const std::function<void(std::size_t, const ChildResult&)>& done_;
  const PoolOptions& options_;
  std::vector<Child> children_;
};

}  // namespace

bool run_jobs(std::size_t count, const std::function<std::string(std::size_t)>& job,
              const std::function<void(std::size_t, const ChildResult&)>& done, const PoolOptions& options) {
  return Pool(job, done, options).run(count);
}

}  // namespace tumble::golden
