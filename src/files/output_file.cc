#include "src/files/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "src/base/check.h"
#include "src/files/file_identity.h"
#include "src/files/part_file.h"

namespace tumble::files {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 16;

}  // namespace

int open_to_write(const std::string& place, int flags) {
  const int file = ::open(place.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK | flags, 0666);
  if (file >= 0) static_cast<void>(::fcntl(file, F_SETFL, ::fcntl(file, F_GETFL) & ~O_NONBLOCK));
  return file;
}

Error cannot_open(const std::string& path, int error) {
  struct stat info = {};
  if (error == ENXIO && ::stat(path.c_str(), &info) == 0 && S_ISFIFO(info.st_mode)) {
    return bad_input(path + ": is a pipe that nothing reads; begin to read it first");
  }
  const bool is_systems = error == EROFS || error == ENOSPC || error == EDQUOT || error == EIO || error == EMFILE ||
                          error == ENFILE || error == ENOMEM;
  const std::string message = path + ": cannot be written: " + std::strerror(error);
  return is_systems ? cannot_finish(message) : bad_input(message);
}

Status can_write_in(const std::string& folder, const std::string& path) {
  if (::access(folder.c_str(), W_OK | X_OK) == 0) return {};
  return cannot_open(path, errno);
}

Status may_write(const std::string& path, const std::string& named) {
  const std::string& name = named.empty() ? path : named;
  const std::filesystem::path place = resolved(path);
  struct stat old = {};
  const bool exists = ::stat(place.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) return bad_input(name + ": is a folder; name a file");
  if (exists && ::access(place.c_str(), W_OK) != 0) return cannot_open(name, errno);
  if (exists && !S_ISREG(old.st_mode)) return {};  // a device or a pipe, which is written to as it is
  return can_write_in(place.has_parent_path() ? place.parent_path().string() : ".", name);
}

Result<OutputFile> OutputFile::create(const std::string& path) {
  if (Status ok = may_write(path); !ok.ok()) return ok.error();
  OutputFile out;
  out.path_ = path;
  out.place_ = resolved(path).string();
  struct stat old = {};
  const bool exists = ::stat(out.place_.c_str(), &old) == 0;
  out.in_place_ = exists && !S_ISREG(old.st_mode);
  out.replaces_ = exists && !out.in_place_;
  if (out.in_place_) {
    out.part_ = out.place_;
    out.file_ = open_to_write(out.place_, 0);
  } else {
    out.file_ = open_part(out.place_, out.part_);
  }
  if (out.file_ < 0) return cannot_open(path, errno);
  if (out.replaces_) static_cast<void>(::fchmod(out.file_, old.st_mode & 07777));
  return out;
}

OutputFile::OutputFile(OutputFile&& other) noexcept { *this = std::move(other); }

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
  if (this == &other) return *this;
  discard();
  path_ = std::move(other.path_);
  place_ = std::move(other.place_);
  part_ = std::exchange(other.part_, "");
  buffer_ = std::move(other.buffer_);
  file_ = std::exchange(other.file_, -1);
  in_place_ = other.in_place_;
  replaces_ = other.replaces_;
  return *this;
}

OutputFile::~OutputFile() { discard(); }

void OutputFile::discard() {
  if (file_ >= 0) ::close(std::exchange(file_, -1));
  if (!in_place_ && !part_.empty()) {
    ::unlink(part_.c_str());
    forget_part(part_);
  }
  part_.clear();
}

Error OutputFile::failed() const { return cannot_finish(path_ + ": could not be written: " + std::strerror(errno)); }

Status OutputFile::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(file_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return failed();
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
  return {};
}

Status OutputFile::write(std::string_view bytes) {
  buffer_ += bytes;
  return buffer_.size() < kBlock ? Status() : flush();
}

Status OutputFile::write_at(std::uint64_t place, std::string_view bytes) {
  SIM_CHECK(!in_place_);
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(place));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return failed();
    bytes.remove_prefix(static_cast<std::size_t>(written));
    place += static_cast<std::uint64_t>(written);
  }
  return {};
}

Status OutputFile::sync() const {
  while (::fdatasync(file_) != 0) {
    if (errno == EINVAL || errno == EROFS) return {};  // not a file on a disk
    if (errno != EINTR) return failed();
  }
  return {};
}

Status OutputFile::commit() {
  if (Status ok = flush(); !ok.ok()) return ok;
  // Else a loss of power after the renaming could leave neither the old content nor the new.
  if (Status ok = replaces_ ? sync() : Status(); !ok.ok()) return ok;
  if (::close(std::exchange(file_, -1)) != 0) return failed();
  if (in_place_) return {};
  if (std::rename(part_.c_str(), place_.c_str()) != 0) return failed();
  forget_part(part_);
  part_.clear();
  return {};
}

Status write_whole_file(const std::string& path, std::string_view content) {
  Result<OutputFile> file = OutputFile::create(path);
  if (!file.ok()) return file.error();
  if (Status ok = file->write(content); !ok.ok()) return ok;
  return file->commit();
}

}  // namespace tumble::files
