#include "src/files/part_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

#include "src/files/ending_names.h"
#include "src/files/file_identity.h"
#include "src/files/maker_in_name.h"

namespace tumble::files {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kStemMax = 200;  // of a name: 255 bytes at most, and a part's name is longer
constexpr int kTriesMax = 1000;

constinit EndingNames open_parts;

/// The process that a part of this stem was made by; none for another file.
std::optional<pid_t> maker_of(std::string_view name, std::string_view stem) {
  const std::optional<MakerInName> maker = maker_in(name, stem);
  if (!maker) return std::nullopt;
  int number = 0;
  const char* const end = maker->rest.data() + maker->rest.size();
  const auto [stop, error] = std::from_chars(maker->rest.data(), end, number);
  return error == std::errc() && stop == end ? std::optional(maker->process) : std::nullopt;
}

struct flock whole_file() {
  struct flock lock = {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

/// Neither the lock of open_part() nor that of a log.
bool is_unlocked(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return false;
  struct flock other = whole_file();
  const bool is_free = ::fcntl(file, F_GETLK, &other) == 0 && other.l_type == F_UNLCK;
  const bool unlocked = is_free && ::flock(file, LOCK_EX | LOCK_NB) == 0;
  ::close(file);
  return unlocked;
}

void remove_leftovers(const fs::path& folder, const std::string& stem) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::optional<pid_t> maker = maker_of(at->path().filename().string(), stem);
    if (!maker || !is_gone(*maker) || !is_unlocked(at->path())) continue;
    std::error_code ignored;
    fs::remove(at->path(), ignored);
  }
}

}  // namespace

int open_part(const std::string& place, std::string& part) {
  const fs::path path = place;
  const fs::path folder = folder_of(path);
  const std::string stem = path.filename().string().substr(0, kStemMax) + ".part-";
  remove_leftovers(folder, stem);
  for (int k = 0; k < kTriesMax; ++k) {
    part = (folder / (stem + std::to_string(::getpid()) + '-' + std::to_string(k))).string();
    const NamesHeld held;
    const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    struct flock own = whole_file();  // excludes no sink that this process opens for a log of that name
    if (file >= 0) static_cast<void>(::fcntl(file, F_SETLK, &own));
    if (file >= 0) open_parts.remember(part);
    if (file >= 0 || errno != EEXIST) return file;
  }
  return -1;
}

void forget_part(const std::string& part) { open_parts.forget(part); }

void remove_parts() {
  open_parts.remove_all([](const char* part) { ::unlink(part); });
}

}  // namespace tumble::files
