#include "tools/bisect/workplace.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

#include "tumble/sim/hash.h"

namespace tumble::tools::bisect {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLockFile = "bisect.lock";

Result<std::string> default_folder(const std::string& fingerprint) {
  std::error_code error;
  const fs::path place = fs::temp_directory_path(error);
  if (error)
    return cannot_finish("TMPDIR: names no folder, wanted one for the clone and the answers; or name one with --work");
  const std::string ours = (place / ("tumble-bisect-" + std::to_string(geteuid()))).string();
  if (Status ok = make_private(ours, "--work"); !ok.ok()) return ok.error();
  const Hash128 hash = hash_bytes(std::as_bytes(std::span(fingerprint)));
  return ours + '/' + to_string(hash).substr(0, 16);
}

}  // namespace

Status make_private(const std::string& folder, const std::string& option) {
  std::error_code error;
  fs::create_directories(fs::path(folder).parent_path(), error);
  if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) {
    return cannot_finish(folder + ": cannot be made: " + std::error_code(errno, std::generic_category()).message());
  }
  struct stat facts = {};
  if (lstat(folder.c_str(), &facts) != 0 || !S_ISDIR(facts.st_mode) || facts.st_uid != geteuid() ||
      (facts.st_mode & (S_IWGRP | S_IWOTH)) != 0) {
    return bad_input(folder + ": must be a folder of yours that nobody else can write to; name another with " + option);
  }
  return {};
}

Workplace::Workplace(Workplace&& other) noexcept
    : root_(std::exchange(other.root_, "")),
      part_(std::exchange(other.part_, "")),
      lock_(std::exchange(other.lock_, -1)) {}

Workplace& Workplace::operator=(Workplace&& other) noexcept {
  std::swap(root_, other.root_);
  std::swap(part_, other.part_);
  std::swap(lock_, other.lock_);
  return *this;
}

Workplace::~Workplace() {
  if (lock_ >= 0) close(lock_);
}

Result<Workplace> Workplace::open(const std::string& folder, const std::string& fingerprint, bool resume,
                                  files::OutputGuard& guard) {
  Result<std::string> root = folder.empty() ? default_folder(fingerprint) : Result<std::string>(folder);
  if (!root.ok()) return root.error();
  if (Status ok = make_private(*root, "--work"); !ok.ok()) return ok.error();
  if (Status ok = guard.claim_folder("--work", *root); !ok.ok()) return ok.error();
  Workplace place;
  place.root_ = *root;
  std::error_code error;
  const bool is_ours = fs::exists(place.file(kLockFile), error);
  if (!is_ours && !fs::is_empty(place.root_, error)) {
    return bad_input(place.root_ + ": holds other things; name an empty or a new folder");
  }
  // Child processes keep the lock open: as long as one of them works here, no other bisection does.
  place.lock_ = ::open(place.file(kLockFile).c_str(), O_RDWR | O_CREAT, 0600);  // NOLINT(android-cloexec-open)
  if (place.lock_ < 0) return cannot_finish(place.root_ + ": cannot be written to");
  if (flock(place.lock_, LOCK_EX | LOCK_NB) != 0) {
    return cannot_finish(place.root_ + ": another bisection, or a program that it started, still works there");
  }
  if (resume && !fs::exists(place.state(), error)) {
    return bad_input("--resume: found no interrupted bisection of this question in " + place.root_ +
                     "; the arguments must be those that it was begun with");
  }
  if (!resume) {
    for (const fs::directory_entry& entry : fs::directory_iterator(place.root_, error)) {
      if (entry.path().filename() != kLockFile) fs::remove_all(entry.path(), error);
    }
  }
  fs::create_directories(place.file("sessions"), error);
  return place;
}

Workplace Workplace::part(std::uint64_t k) const {
  Workplace place;
  place.root_ = root_;
  if (k == 0) return place;
  place.part_ = std::to_string(k) + '/';
  std::error_code ignored;
  fs::create_directories(place.file(""), ignored);
  return place;
}

void Workplace::remove() {
  std::error_code ignored;
  fs::remove_all(root_, ignored);
}

}  // namespace tumble::tools::bisect
