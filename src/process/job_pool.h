#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace tumble::process {

/// The end of one job.
struct JobResult {
  std::string output;   ///< returned by the job; empty if it failed
  std::string failure;  ///< "ended by SIGSEGV", "took longer than 600 s", …; empty: it finished
  double seconds = 0;   ///< of wall time
};

struct PoolOptions {
  std::size_t jobs = 1;          ///< children at a time
  double timeout_s = 600;        ///< of each child, wall time; then it and all it started are killed
  unsigned cpu_s = 0;            ///< of each child, processor time, which a busy machine does not stretch; 0: any
  std::function<bool()> cancel;  ///< asked a few times a second; true ends all children; may be empty
};

/// Runs jobs 0 … count − 1, each in a forked child of its own, started in that order: a job that crashes or hangs harms
/// no other, and whatever ends this process ends them and the programs that they started (Linux). Calls `done` in this
/// process as each of them ends, in the order in which they end. Returns false if cancelled. Precondition: the caller
/// has no other threads, for fork() copies one alone.
bool run_jobs(std::size_t count, const std::function<std::string(std::size_t)>& job,
              const std::function<void(std::size_t, const JobResult&)>& done, const PoolOptions& options);

}  // namespace tumble::process
