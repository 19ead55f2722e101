#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "tumble/sim/workers.h"

namespace tumble::bench {

/// Workers that take turns: one part runs at a time, until it ends, meets the others or waits for a post, and each turn
/// is timed. What parts do between two meetings is a round of its own.
class TimedParts : public Workers {
 public:
  /// Splits work into parts of a `divisor`-th of the sizes that phases have measured. post_s: s until another part sees
  /// a post.
  TimedParts(unsigned count, std::size_t divisor, double post_s);
  ~TimedParts() override;
  TimedParts(const TimedParts&) = delete;
  TimedParts& operator=(const TimedParts&) = delete;

  [[nodiscard]] unsigned count() const override { return count_; }
  [[nodiscard]] std::size_t worth(std::size_t least) const override;
  [[nodiscard]] bool take_turns() const override { return true; }
  void run(unsigned parts, void (*task)(void* context, unsigned part), void* context) override;
  bool meet(unsigned part, bool any) override;
  void post(unsigned part, std::uint32_t number) override;
  std::uint32_t await(unsigned part, unsigned other, std::uint32_t number) override;

  struct Round {
    std::vector<double> parts;  ///< s, the work of each part
    double path = 0;            ///< s until the last part is done, if they ran at the same time
  };
  /// The rounds since the last call.
  struct Rounds {
    std::vector<Round> all;
    double inside_s = 0;  ///< spent in run()
  };
  Rounds take() { return std::exchange(rounds_, {}); }  // no part runs now

 private:
  enum class At : std::uint8_t { kWorking, kMeeting, kAwaiting, kEnded };
  struct Post {
    std::uint32_t number = 0;
    double clock = 0;
  };
  struct Part {
    At at = At::kWorking;
    unsigned other = 0;  // whose post it awaits
    std::uint32_t number = 0;
    double began = 0;            // s, the present turn
    double work = 0, clock = 0;  // s since the last meeting; the latter with waiting for posts
    std::vector<Post> posts;
  };

  void work(unsigned part);
  bool has_posted(unsigned part, std::uint32_t number) const;
  void count_work(unsigned part);
  void end_turn(std::unique_lock<std::mutex>& lock, unsigned part, At at);
  void pass_turn(unsigned part);
  void give_turn(unsigned part);

  static constexpr unsigned kNobody = 0xffffffffU;

  unsigned count_;
  std::size_t divisor_;
  double post_s_;
  std::mutex mutex_;
  std::vector<std::condition_variable> turns_;  // by part
  std::condition_variable all_ended_;
  unsigned turn_ = kNobody;
  bool stop_ = false;
  bool any_ = false, any_before_ = false;  // of the meeting that parts arrive at; of the last one that all have reached
  unsigned running_ = 0;                   // parts of the task
  void (*task_)(void*, unsigned) = nullptr;
  void* context_ = nullptr;
  std::vector<Part> parts_;
  Rounds rounds_;
  std::vector<std::thread> threads_;
};

}  // namespace tumble::bench
