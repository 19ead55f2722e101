#include "src/files/short_lived_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#ifdef __linux__
#include <dirent.h>
#endif

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

#include "src/files/ending_names.h"
#include "src/files/file_identity.h"
#include "src/files/maker_in_name.h"

namespace tumble::files {
namespace {

constinit EndingNames folders;

constexpr std::size_t kLetters = 6;  // that mkdtemp() chooses
constexpr int kFolderTriesMax = 100;
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

/// A folder, opened and locked against who would remove it as left over; −1 where another holds the lock, or it is
/// none.
int locked_folder(const char* name) {
  const int folder = ::open(name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (folder < 0 || ::flock(folder, LOCK_EX | LOCK_NB) == 0) return folder;
  ::close(folder);
  return -1;
}

/// The process that a folder of this stem was made by; none for another one.
std::optional<pid_t> maker_of_folder(std::string_view name, std::string_view stem) {
  const std::optional<MakerInName> maker = maker_in(name, stem);
  return maker && maker->rest.size() == kLetters ? std::optional(maker->process) : std::nullopt;
}

void remove_left_over(const char* name) {
  const int folder = locked_folder(name);
  if (folder < 0) return;
  struct stat info = {};
  if (::fstat(folder, &info) == 0 && info.st_uid == ::geteuid()) remove_entry(AT_FDCWD, name, 0);
  ::close(folder);
}

void sweep(const std::string& place, std::string_view stem) {
  std::error_code error;
  for (std::filesystem::directory_iterator at(place, error), end; !error && at != end; at.increment(error)) {
    const std::optional<pid_t> maker = maker_of_folder(at->path().filename().string(), stem);
    if (maker && is_gone(*maker)) remove_left_over(at->path().c_str());
  }
}

/// A folder that nobody took for left over before it was locked; that can only be a process that does not see this one,
/// as one of another container.
bool make_locked(const std::string& pattern, std::string& name, int& lock) {
  for (int k = 0; k < kFolderTriesMax; ++k) {
    name = pattern;
    if (::mkdtemp(name.data()) == nullptr) return false;
    lock = locked_folder(name.c_str());
    struct stat info = {};
    const bool is_ours = lock >= 0 && ::fstat(lock, &info) == 0;
    if (is_ours && identity_of(name.c_str()) == FileIdentity{info.st_dev, info.st_ino}) return true;
    if (lock >= 0) ::close(lock);
  }
  errno = EAGAIN;
  return false;
}

}  // namespace

std::string make_short_lived_folder(const std::string& place, const std::string& prefix) {
  const std::string stem = prefix + '-';
  const int errno_before = errno;
  sweep(place, stem);
  const std::filesystem::path pattern = std::filesystem::path(place) / (stem + std::to_string(::getpid()) + "-XXXXXX");
  const std::string letters = pattern.string();
  std::string name = letters;
  int lock = -1;
  const NamesHeld held;
  const bool made = make_locked(letters, name, lock);
  const int error = made ? errno_before : errno;
  if (made) folders.remember(name, lock);
  errno = error;
  return made ? name : "";
}

void forget_short_lived_folder(const std::string& folder) { folders.forget(folder); }

void remove_short_lived_folders() {
  folders.remove_all([](const char* folder) { remove_entry(AT_FDCWD, folder, 0); });
}

}  // namespace tumble::files
