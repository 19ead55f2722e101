#include "src/files/ending_names.h"

#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <type_traits>

namespace tumble::files {
namespace {

constexpr timespec kPause = {0, 1'000'000};
constexpr int kPausesMax = 1000;  // a thread that was making a name when this process was forked never ends that

// Read by the handler of a signal, in whichever thread that runs.
std::atomic<int> holders = 0;
std::atomic<pid_t> ending = 0;  // the process whose names are being removed
static_assert(std::atomic<int>::is_always_lock_free && std::is_same_v<pid_t, int>);

// Another thread may write a row's name while one looks for its own; a number it may read meanwhile.
std::size_t key_of(const std::string& name) { return std::hash<std::string>()(name); }

}  // namespace

NamesHeld::NamesHeld() {
  sigset_t all;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_BLOCK, &all, &before_);
  ++holders;
  if (ending != ::getpid()) return;
  --holders;
  for (;;) ::pause();
}

NamesHeld::~NamesHeld() {
  --holders;
  ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void EndingNames::remember(const std::string& name, int lock) {
  for (Row& row : rows_) {
    int free = Row::kFree;
    if (name.size() >= row.name.size() || !row.state.compare_exchange_strong(free, Row::kTaken)) continue;
    std::copy_n(name.c_str(), name.size() + 1, row.name.begin());
    row.key = key_of(name);
    row.process = ::getpid();
    row.lock = lock;
    row.state = Row::kNamed;
    return;
  }
  if (lock >= 0) ::close(lock);
}

void EndingNames::forget(const std::string& name) {
  for (Row& row : rows_) {
    if (row.state != Row::kNamed || row.key != key_of(name)) continue;
    if (row.lock >= 0) ::close(row.lock);
    row.state = Row::kFree;
    return;
  }
}

void EndingNames::remove_all(void (*remove)(const char* name)) {
  ending = ::getpid();
  for (int k = 0; k < kPausesMax && holders > 0; ++k) ::nanosleep(&kPause, nullptr);
  for (Row& row : rows_) {
    if (row.state == Row::kNamed && row.process == ::getpid()) remove(row.name.data());
  }
}

}  // namespace tumble::files
