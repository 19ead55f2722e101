#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace tumble::golden {

/// What a child process left behind.
struct ChildResult {
  std::string output;   ///< what its job returned; empty if it did not come to that
  std::string failure;  ///< "ended by SIGSEGV", "took longer than 600 s", …; empty: it finished
  double seconds = 0;   ///< of wall time
};

struct PoolOptions {
  std::size_t jobs = 1;          ///< children at a time
  double timeout_s = 600;        ///< of each child; then it and all it started are killed
  std::function<bool()> cancel;  ///< asked a few times a second; true ends all children; may be empty
};

/// Runs jobs 0 … count − 1, each in a forked child of its own, started in that order: a job that crashes or hangs takes
/// nothing with it. done is called in this process as each of them ends, in the order in which they end. The caller
/// must not have other threads. Returns false if cancelled.
bool run_jobs(std::size_t count, const std::function<std::string(std::size_t)>& job,
              const std::function<void(std::size_t, const ChildResult&)>& done, const PoolOptions& options);

}  // namespace tumble::golden
