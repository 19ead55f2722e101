#include "tumble/threads/worker_threads.h"

#include <chrono>
#include <system_error>

#include "src/base/check.h"

namespace tumble {
namespace {

constexpr int kPolls = 4000;  // some 50 µs: longer than most work between two splits

constexpr int kEagerPolls = 200;  // without a pause: a neighbour's post mostly comes within its next batch

constexpr int kYields = 200;  // to other threads, where there are more of them than processors
constexpr std::chrono::microseconds kNap(20);

void pause_processor() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

// A meeting and two flags, of this meeting and of the one before, in one word. A worker may arrive at the next meeting
// while others still read the flag of this one, but not at the one after that.
constexpr unsigned kFlags = 2;
constexpr std::uint32_t flag_of(std::uint32_t meeting) { return 1U << (meeting & 1U); }
// Waits until done(): others are at work on the same round. A worker that waits for long has taken the processor of
// another one, so it gives it away; with a nap it comes back late.
template <class Done>
void give_way(Done done) {
  for (int k = 0; k < kYields; ++k) {
    if (done()) return;
    std::this_thread::yield();
  }
  while (!done()) std::this_thread::sleep_for(kNap);
}

// Numbers of meetings wrap around.
constexpr bool has_arrived(std::uint32_t at, std::uint32_t meeting) {
  return static_cast<std::int32_t>(at - (meeting << kFlags)) >= 0;
}

}  // namespace

// With more threads than processors a polling thread would take the time of a working one.
WorkerThreads::WorkerThreads(unsigned count, Split split)
    : split_(split), polls_(count <= std::thread::hardware_concurrency() ? kPolls : 0), places_(count), posts_(count) {
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
  for (unsigned part = 0; part < parts; ++part) posts_[part].at.store(0, std::memory_order_relaxed);
  busy_.store(static_cast<unsigned>(threads_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  task(context, 0);
  for (int k = 0; k < polls_ && busy_.load(std::memory_order_acquire) != 0; ++k) pause_processor();
  for (unsigned busy = 0; (busy = busy_.load(std::memory_order_acquire)) != 0;) busy_.wait(busy);
  meetings_ = places_[0].at.load(std::memory_order_relaxed) >> kFlags;
}

bool WorkerThreads::meet(unsigned part, bool any) {
  std::atomic<std::uint32_t>& own = places_[part].at;
  const std::uint32_t before = own.load(std::memory_order_relaxed);
  const std::uint32_t meeting = (before >> kFlags) + 1, flag = flag_of(meeting);
  const std::uint32_t kept = before & (flag ^ ((1U << kFlags) - 1));
  own.store(meeting << kFlags | kept | (any ? flag : 0U), std::memory_order_release);
  for (unsigned other = 0; other < parts_; ++other) {
    if (other == part) continue;
    wait_for(places_[other], meeting);
    any |= (places_[other].at.load(std::memory_order_relaxed) & flag) != 0;
  }
  return any;
}

void WorkerThreads::wait_for(const Place& place, std::uint32_t meeting) const {
  const auto arrived = [&] { return has_arrived(place.at.load(std::memory_order_acquire), meeting); };
  for (int k = 0; k < polls_ && !arrived(); ++k) pause_processor();
  give_way(arrived);
}

void WorkerThreads::post(unsigned part, std::uint32_t number) {
  posts_[part].at.store(number, std::memory_order_release);
}

std::uint32_t WorkerThreads::await(unsigned /*part*/, unsigned other, std::uint32_t number) {
  const std::atomic<std::uint32_t>& post = posts_[other].at;
  std::uint32_t last = post.load(std::memory_order_acquire);
  for (int k = 0; last < number && k < polls_; ++k) {
    if (k >= kEagerPolls) pause_processor();
    last = post.load(std::memory_order_acquire);
  }
  give_way([&] {
    last = post.load(std::memory_order_acquire);
    return last >= number;
  });
  return last;
}

void WorkerThreads::work(unsigned worker) {
  for (std::uint32_t seen = 0;; ++seen) {
    for (int k = 0; k < polls_ && round_.load(std::memory_order_acquire) == seen; ++k) pause_processor();
    round_.wait(seen, std::memory_order_acquire);
    if (stop_) return;
    // A worker that was not needed has missed meetings.
    places_[worker].at.store(meetings_ << kFlags, std::memory_order_relaxed);
    if (worker < parts_) task_(context_, worker);
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
  }
}

std::unique_ptr<WorkerThreads> worker_threads(std::uint64_t count) {
  return count < 2 ? nullptr : std::make_unique<WorkerThreads>(static_cast<unsigned>(count));
}

}  // namespace tumble
