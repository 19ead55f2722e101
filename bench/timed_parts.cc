#include "bench/timed_parts.h"

#include <algorithm>

#include "bench/thread_trials.h"

namespace tumble::bench {
namespace {

double now_s() { return std::chrono::duration<double>(Clock::now().time_since_epoch()).count(); }

}  // namespace

TimedParts::TimedParts(unsigned count, std::size_t divisor) : count_(count), divisor_(divisor), turns_(count) {
  for (unsigned part = 0; part < count; ++part) threads_.emplace_back([this, part] { work(part); });
}

TimedParts::~TimedParts() {
  {
    const std::scoped_lock lock(mutex_);
    stop_ = true;
  }
  for (std::condition_variable& turn : turns_) turn.notify_one();
  for (std::thread& thread : threads_) thread.join();
}

std::size_t TimedParts::worth(std::size_t least) const { return std::max<std::size_t>(1, least / divisor_); }

void TimedParts::run(unsigned parts, void (*task)(void*, unsigned), void* context) {
  const double began = now_s();
  std::unique_lock lock(mutex_);
  task_ = task;
  context_ = context;
  parts_ = left_ = parts;
  any_ = false;
  rounds_.seconds.emplace_back();
  ++rounds_.forks;
  turn_ = 0;
  turns_[0].notify_one();
  all_ended_.wait(lock, [&] { return left_ == 0; });
  rounds_.inside_s += now_s() - began;
}

bool TimedParts::meet(unsigned part, bool any) {
  std::unique_lock lock(mutex_);
  any_ = part == 0 ? any : any_ || any;
  end_turn(part);
  wait_for_turn(lock, part);
  if (part == 0) {
    any_before_ = any_;
    rounds_.seconds.emplace_back();
  }
  began_ = now_s();
  return any_before_;
}

void TimedParts::work(unsigned part) {
  std::unique_lock lock(mutex_);
  for (;;) {
    wait_for_turn(lock, part);
    if (stop_) return;
    began_ = now_s();
    lock.unlock();
    task_(context_, part);
    lock.lock();
    --left_;
    end_turn(part);
  }
}

void TimedParts::wait_for_turn(std::unique_lock<std::mutex>& lock, unsigned part) {
  turns_[part].wait(lock, [&] { return stop_ || turn_ == part; });
}

// With the lock held. The parts of a task meet equally often, so all end in the same round.
void TimedParts::end_turn(unsigned part) {
  rounds_.seconds.back().push_back(now_s() - began_);
  turn_ = left_ == 0 ? kNobody : (part + 1) % parts_;
  if (left_ == 0) {
    all_ended_.notify_one();
  } else {
    turns_[turn_].notify_one();
  }
}

}  // namespace tumble::bench
