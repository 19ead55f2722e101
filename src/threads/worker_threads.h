#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

#include "tumble/sim/workers.h"

namespace tumble {

/// Which work is split: work that is large enough to gain by a split, or all of it (tests then need no large scenes).
enum class Split { kWhatPays, kEverything };

/// A fixed number of threads that wait for work. One caller at a time. Two counters hand over the work, without a lock:
/// a thread polls its counter for some microseconds, since phases follow each other closely, and sleeps after that.
class WorkerThreads : public Workers {
 public:
  /// The calling thread counts as one. Where the system refuses a thread, there are fewer. Precondition: count >= 1.
  explicit WorkerThreads(unsigned count, Split split = Split::kWhatPays);
  ~WorkerThreads() override;
  WorkerThreads(const WorkerThreads&) = delete;
  WorkerThreads& operator=(const WorkerThreads&) = delete;

  [[nodiscard]] unsigned count() const override { return static_cast<unsigned>(threads_.size()) + 1; }
  [[nodiscard]] std::size_t worth(std::size_t least) const override { return split_ == Split::kEverything ? 1 : least; }
  void run(unsigned parts, void (*task)(void* context, unsigned part), void* context) override;
  bool meet(unsigned part, bool any) override;
  void post(unsigned part, std::uint32_t number) override;
  std::uint32_t await(unsigned part, unsigned other, std::uint32_t number) override;

 private:
  // Where a worker has arrived: the number of its last meeting, and what it said at that one and the one before. A line
  // of its own, which only this worker writes.
  struct alignas(128) Place {
    std::atomic<std::uint32_t> at = 0;
  };

  void work(unsigned worker);
  void wait_for(const Place& place, std::uint32_t meeting) const;

  Split split_;
  int polls_;  // of a counter before sleeping
  // The work of the round; written before `round_` counts up, read after.
  void (*task_)(void*, unsigned) = nullptr;
  void* context_ = nullptr;
  unsigned parts_ = 0;
  std::uint32_t meetings_ = 0;  // before the round
  bool stop_ = false;
  alignas(64) std::atomic<std::uint32_t> round_ = 0;
  alignas(64) std::atomic<unsigned> busy_ = 0;  // threads that have not finished the round
  std::vector<Place> places_;                   // by part
  std::vector<Place> posts_;                    // by part: the last number that it has posted in this round
  std::vector<std::thread> threads_;
};

/// Workers for a number of threads; null for fewer than 2, when the calling thread does all.
std::unique_ptr<WorkerThreads> worker_threads(std::uint64_t count);

}  // namespace tumble
