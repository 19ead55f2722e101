#include "src/files/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "src/base/text.h"
#include "src/files/file_identity.h"
#include "src/files/output_file.h"

namespace tumble::files {
namespace {

struct flock lock_of_all() {
  struct flock lock = {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

/// "tumble record tower -o x.tumble": a process's command line; empty where the system does not show it.
std::string command_of(pid_t process) {
  constexpr std::size_t kTextMax = 200;
  std::ifstream file("/proc/" + std::to_string(process) + "/cmdline", std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  while (!text.empty() && text.back() == '\0') text.pop_back();
  std::ranges::replace(text, '\0', ' ');
  if (text.size() > kTextMax) text = text.substr(0, kTextMax) + "…";
  return printable(text);
}

}  // namespace

bool lock(int file) {
  if (::flock(file, LOCK_EX | LOCK_NB) != 0) return errno != EWOULDBLOCK;
  // A second lock, which excludes nobody, holds the number of this process for holder_of().
  struct flock owner = lock_of_all();
  static_cast<void>(::fcntl(file, F_SETLK, &owner));
  return true;
}

std::string holder_of(int file) {
  struct flock owner = lock_of_all();
  if (::fcntl(file, F_GETLK, &owner) != 0 || owner.l_type == F_UNLCK || owner.l_pid <= 0) return "";
  const std::string command = command_of(owner.l_pid);
  return "process " + std::to_string(owner.l_pid) + (command.empty() ? "" : " (" + command + ")");
}

Result<FolderLock> FolderLock::take(const std::filesystem::path& folder, const std::string& name,
                                    const std::string& what) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return cannot_open(folder.string(), error.value());
  const std::filesystem::path path = folder / name;
  for (;;) {
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
    if (file < 0) return cannot_open(path.string(), errno);
    struct stat info = {};
    if (!lock(file)) {
      const std::string who = holder_of(file);
      ::close(file);
      return bad_input(folder.string() + ": " + what + " works there, " + (who.empty() ? "another process" : who) +
                       "; wait until it ends, or name another folder");
    }
    // Whoever held it may have removed the file meanwhile.
    if (::fstat(file, &info) == 0 && identity_of(path) == FileIdentity{info.st_dev, info.st_ino})
      return FolderLock(path, file);
    ::close(file);
  }
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}

FolderLock::~FolderLock() {
  if (file_ < 0) return;
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
  ::close(file_);
}

}  // namespace tumble::files
