#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

#include "src/base/workers.h"

namespace tumble {

/// What to split: what is large enough for it to pay, or everything (so that tests need no large scenes).
enum class Split { kWhatPays, kEverything };

/// A fixed number of threads that wait for work. One caller at a time. Work is handed over through two counters and no
/// lock: a thread looks for it busily for a few microseconds, as phases follow each other closely, then sleeps.
class WorkerThreads : public Workers {
 public:
  /// The calling thread is one of them. Precondition: count >= 1. Where the system gives no more threads, there are
  /// fewer.
  explicit WorkerThreads(unsigned count, Split split = Split::kWhatPays);
  ~WorkerThreads() override;
  WorkerThreads(const WorkerThreads&) = delete;
  WorkerThreads& operator=(const WorkerThreads&) = delete;

  [[nodiscard]] unsigned count() const override { return static_cast<unsigned>(threads_.size()) + 1; }
  [[nodiscard]] std::size_t worth(std::size_t least) const override { return split_ == Split::kEverything ? 1 : least; }
  void run(unsigned parts, void (*task)(void* context, unsigned part), void* context) override;

 private:
  void work(unsigned hand);

  Split split_;
  int looks_;  // for work or its end before sleeping
  // What is to be done; written before `round_` counts up, read after.
  void (*task_)(void*, unsigned) = nullptr;
  void* context_ = nullptr;
  unsigned parts_ = 0;
  bool stop_ = false;
  alignas(64) std::atomic<std::uint32_t> round_ = 0;
  alignas(64) std::atomic<unsigned> busy_ = 0;  // threads that have not finished the round
  std::vector<std::thread> threads_;
};

/// Threads to step with: null for 1, as the simulation needs none then.
std::unique_ptr<WorkerThreads> worker_threads(std::uint64_t count);

}  // namespace tumble
