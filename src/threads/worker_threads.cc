#include "tumble/threads/worker_threads.h"

#include <system_error>

#include "src/base/check.h"

namespace tumble {
namespace {

constexpr int kPolls = 4000;  // some 50 µs: longer than most work between two splits

void pause_processor() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

// With more threads than processors a polling thread would take the time of a working one.
WorkerThreads::WorkerThreads(unsigned count, Split split)
    : split_(split), polls_(count <= std::thread::hardware_concurrency() ? kPolls : 0) {
  SIM_CHECK(count >= 1, count);
  threads_.reserve(count - 1);
  try {
    for (unsigned worker = 1; worker < count; ++worker) threads_.emplace_back([this, worker] { work(worker); });
  } catch (const std::system_error&) {
    return;  // with the threads that there are
  }
}

WorkerThreads::~WorkerThreads() {
  stop_ = true;
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void WorkerThreads::run(unsigned parts, void (*task)(void* context, unsigned part), void* context) {
  SIM_CHECK(parts <= this->count(), parts, this->count());
  task_ = task;
  context_ = context;
  parts_ = parts;
  busy_.store(static_cast<unsigned>(threads_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  task(context, 0);
  for (int k = 0; k < polls_ && busy_.load(std::memory_order_acquire) != 0; ++k) pause_processor();
  for (unsigned busy = 0; (busy = busy_.load(std::memory_order_acquire)) != 0;) busy_.wait(busy);
}

void WorkerThreads::work(unsigned worker) {
  for (std::uint32_t seen = 0;; ++seen) {
    for (int k = 0; k < polls_ && round_.load(std::memory_order_acquire) == seen; ++k) pause_processor();
    round_.wait(seen, std::memory_order_acquire);
    if (stop_) return;
    if (worker < parts_) task_(context_, worker);
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
  }
}

std::unique_ptr<WorkerThreads> worker_threads(std::uint64_t count) {
  return count < 2 ? nullptr : std::make_unique<WorkerThreads>(static_cast<unsigned>(count));
}

}  // namespace tumble
