#include "src/threads/worker_threads.h"

#include <system_error>

namespace tumble {
namespace {

constexpr int kLooks = 4000;  // some 50 µs, longer than most of what is done between two splits

void rest_a_moment() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

// With more threads than processors, one that looks keeps another from working.
WorkerThreads::WorkerThreads(unsigned count, Split split)
    : split_(split), looks_(count <= std::thread::hardware_concurrency() ? kLooks : 0) {
  threads_.reserve(count - 1);
  try {
    for (unsigned hand = 1; hand < count; ++hand) threads_.emplace_back([this, hand] { work(hand); });
  } catch (const std::system_error&) {
    return;  // those that there are will do
  }
}

WorkerThreads::~WorkerThreads() {
  stop_ = true;
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void WorkerThreads::run(unsigned parts, void (*task)(void* context, unsigned part), void* context) {
  task_ = task;
  context_ = context;
  parts_ = parts;
  busy_.store(static_cast<unsigned>(threads_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  task(context, 0);
  for (int k = 0; k < looks_ && busy_.load(std::memory_order_acquire) != 0; ++k) rest_a_moment();
  for (unsigned busy = 0; (busy = busy_.load(std::memory_order_acquire)) != 0;) busy_.wait(busy);
}

void WorkerThreads::work(unsigned hand) {
  for (std::uint32_t seen = 0;; ++seen) {
    for (int k = 0; k < looks_ && round_.load(std::memory_order_acquire) == seen; ++k) rest_a_moment();
    round_.wait(seen, std::memory_order_acquire);
    if (stop_) return;
    if (hand < parts_) task_(context_, hand);
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
  }
}

std::unique_ptr<WorkerThreads> worker_threads(std::uint64_t count) {
  return count < 2 ? nullptr : std::make_unique<WorkerThreads>(static_cast<unsigned>(count));
}

}  // namespace tumble
