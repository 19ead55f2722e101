#include "bench/timed_parts.h"

#include <algorithm>

#include "bench/thread_trials.h"

namespace tumble::bench {
namespace {

double now_s() { return std::chrono::duration<double>(Clock::now().time_since_epoch()).count(); }

}  // namespace

TimedParts::TimedParts(unsigned count, std::size_t divisor, double post_s)
    : count_(count), divisor_(divisor), post_s_(post_s), turns_(count), parts_(count) {
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
  running_ = parts;
  any_ = false;
  for (Part& part : parts_) part = {};
  turn_ = 0;
  turns_[0].notify_one();
  all_ended_.wait(lock, [&] { return turn_ == kNobody; });
  rounds_.inside_s += now_s() - began;
}

bool TimedParts::meet(unsigned part, bool any) {
  std::unique_lock lock(mutex_);
  any_ |= any;
  end_turn(lock, part, At::kMeeting);
  return any_before_;
}

void TimedParts::post(unsigned part, std::uint32_t number) {
  const std::scoped_lock lock(mutex_);
  Part& own = parts_[part];
  own.posts.push_back({number, own.clock + (now_s() - own.began)});
}

std::uint32_t TimedParts::await(unsigned part, unsigned other, std::uint32_t number) {
  std::unique_lock lock(mutex_);
  const std::vector<Post>& posts = parts_[other].posts;
  parts_[part].other = other;
  parts_[part].number = number;
  if (!has_posted(other, number)) {
    end_turn(lock, part, At::kAwaiting);
  } else {
    count_work(part);
  }
  const auto post = std::ranges::lower_bound(posts, number, {}, &Post::number);
  parts_[part].clock = std::max(parts_[part].clock, post->clock + post_s_);
  parts_[part].began = now_s();
  return posts.back().number;
}

void TimedParts::work(unsigned part) {
  std::unique_lock lock(mutex_);
  for (;;) {
    turns_[part].wait(lock, [&] { return stop_ || turn_ == part; });
    if (stop_) return;
    parts_[part].began = now_s();
    lock.unlock();
    task_(context_, part);
    lock.lock();
    count_work(part);
    parts_[part].at = At::kEnded;
    pass_turn(part);
  }
}

bool TimedParts::has_posted(unsigned part, std::uint32_t number) const {
  return !parts_[part].posts.empty() && parts_[part].posts.back().number >= number;
}

void TimedParts::count_work(unsigned part) {
  Part& own = parts_[part];
  const double taken = now_s() - own.began;
  own.clock += taken;
  own.work += taken;
}

// With the lock held; returns when it is this part's turn again.
void TimedParts::end_turn(std::unique_lock<std::mutex>& lock, unsigned part, At at) {
  count_work(part);
  parts_[part].at = at;
  pass_turn(part);
  turns_[part].wait(lock, [&] { return turn_ == part; });
  parts_[part].at = At::kWorking;
  parts_[part].began = now_s();
}

void TimedParts::pass_turn(unsigned part) {
  const auto ready = [&](const Part& of) {
    return of.at == At::kWorking || (of.at == At::kAwaiting && has_posted(of.other, of.number));
  };
  for (unsigned k = 1; k <= running_; ++k) {
    const unsigned next = (part + k) % running_;
    if (ready(parts_[next])) return give_turn(next);
  }
  // All have met or ended: the parts of a task meet equally often.
  Round round;
  for (unsigned k = 0; k < running_; ++k) {
    round.parts.push_back(parts_[k].work);
    round.path = std::max(round.path, parts_[k].clock);
    parts_[k].work = parts_[k].clock = 0;
    for (Post& post : parts_[k].posts) post.clock = 0;
  }
  rounds_.all.push_back(std::move(round));
  if (parts_[0].at == At::kEnded) {
    turn_ = kNobody;
    all_ended_.notify_one();
    return;
  }
  any_before_ = any_;
  any_ = false;
  for (unsigned k = 0; k < running_; ++k) parts_[k].at = At::kWorking;
  give_turn(0);
}

void TimedParts::give_turn(unsigned part) {
  turn_ = part;
  turns_[part].notify_one();
}

}  // namespace tumble::bench
