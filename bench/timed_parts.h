#pragma once

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "tumble/sim/workers.h"

namespace tumble::bench {

/// Workers that take turns: one part runs at a time, until it ends or meets the others, and each turn is timed. What
/// parts do between two meetings is a round of its own.
class TimedParts : public Workers {
 public:
  /// Splits work into parts of a `divisor`-th of the sizes that phases have measured.
  TimedParts(unsigned count, std::size_t divisor);
  ~TimedParts() override;
  TimedParts(const TimedParts&) = delete;
  TimedParts& operator=(const TimedParts&) = delete;

  [[nodiscard]] unsigned count() const override { return count_; }
  [[nodiscard]] std::size_t worth(std::size_t least) const override;
  void run(unsigned parts, void (*task)(void*, unsigned), void* context) override;
  bool meet(unsigned part, bool any) override;

  /// The rounds since the last call.
  struct Rounds {
    std::vector<std::vector<double>> seconds;  ///< of each part of each round
    std::size_t forks = 0;                     ///< calls of run(); the other rounds began with a meeting
    double inside_s = 0;                       ///< spent in run()
  };
  Rounds take() { return std::exchange(rounds_, {}); }  // no part runs now

 private:
  void work(unsigned part);
  void wait_for_turn(std::unique_lock<std::mutex>& lock, unsigned part);
  void end_turn(unsigned part);

  static constexpr unsigned kNobody = 0xffffffffU;

  unsigned count_;
  std::size_t divisor_;
  std::mutex mutex_;
  std::vector<std::condition_variable> turns_;  // by part
  std::condition_variable all_ended_;
  unsigned turn_ = kNobody;
  bool stop_ = false, finished_ = false;
  bool any_ = false, any_before_ = false;  // of the meeting that parts arrive at; of the last one that all have reached
  unsigned parts_ = 0, left_ = 0;          // left_: parts that have not ended
  void (*task_)(void*, unsigned) = nullptr;
  void* context_ = nullptr;
  double began_ = 0;  // s, of the present turn
  Rounds rounds_;
  std::vector<std::thread> threads_;
};

}  // namespace tumble::bench
