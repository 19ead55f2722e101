#include "src/files/short_lived_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#ifdef __linux__
#include <dirent.h>
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>

namespace tumble::files {
namespace {

// Where a signal's handler may read them.
struct Row {
  enum State : int { kFree, kTaken, kNamed };
  std::atomic<int> state = kFree;
  pid_t process = 0;
  std::array<char, PATH_MAX> name = {};
};
std::array<Row, 16> rows;
static_assert(std::atomic<int>::is_always_lock_free);

constexpr int kDepthMax = 32;
constexpr int kPassesMax = 1000;  // a folder that another process fills faster than this one empties it stays

#ifdef __linux__
void remove_entry(int folder, const char* name, int depth);

// Removes what a folder holds; whether it held anything. opendir() may not be called in a signal's handler.
bool empty_once(int folder, int depth) {
  alignas(struct dirent64) std::array<char, 4096> buffer;
  bool found = false;
  if (::lseek(folder, 0, SEEK_SET) != 0) return false;
  for (;;) {
    const ssize_t size = ::getdents64(folder, buffer.data(), buffer.size());
    if (size <= 0) return found;
    for (ssize_t at = 0; at < size;) {
      const auto* const entry = reinterpret_cast<const struct dirent64*>(buffer.data() + at);
      at += entry->d_reclen;
      const char* const name = static_cast<const char*>(entry->d_name);
      if (std::strcmp(name, ".") == 0 || std::strcmp(name, "..") == 0) continue;
      found = true;
      remove_entry(folder, name, depth);
    }
  }
}

void remove_entry(int folder, const char* name, int depth) {
  const int inner = ::openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (inner < 0) {
    ::unlinkat(folder, name, 0);
    return;
  }
  for (int pass = 0; depth < kDepthMax && pass < kPassesMax && empty_once(inner, depth + 1); ++pass) {
  }
  ::close(inner);
  ::unlinkat(folder, name, AT_REMOVEDIR);
}
#else
// Without such a call an empty folder alone is removed.
void remove_entry(int folder, const char* name, int /*depth*/) { ::unlinkat(folder, name, AT_REMOVEDIR); }
#endif

void remember(const std::string& folder) {
  for (Row& row : rows) {
    int free = Row::kFree;
    if (folder.size() >= row.name.size() || !row.state.compare_exchange_strong(free, Row::kTaken)) continue;
    std::copy_n(folder.c_str(), folder.size() + 1, row.name.begin());
    row.process = ::getpid();
    row.state = Row::kNamed;
    return;
  }
}

}  // namespace

bool make_short_lived_folder(std::string& pattern) {
  sigset_t all;
  sigset_t before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_BLOCK, &all, &before);  // no signal comes while the folder is there and nobody knows of it
  const bool made = ::mkdtemp(pattern.data()) != nullptr;
  const int error = errno;
  if (made) remember(pattern);
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = error;
  return made;
}

void forget_short_lived_folder(const std::string& folder) {
  for (Row& row : rows) {
    if (row.state == Row::kNamed && folder == row.name.data()) row.state = Row::kFree;
  }
}

void remove_short_lived_folders() {
  for (Row& row : rows) {
    if (row.state == Row::kNamed && row.process == ::getpid()) remove_entry(AT_FDCWD, row.name.data(), 0);
  }
}

}  // namespace tumble::files
