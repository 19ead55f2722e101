#include "src/files/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include "src/files/file_identity.h"

namespace tumble::files {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 16;
constexpr std::size_t kStemMax = 200;  // of a name: 255 bytes at most, and a part's name is longer
constexpr int kTriesMax = 1000;

/// An error of opening: the system's where the disk or its limits are at fault, else the user's.
Error cannot_open(const std::string& path, int error) {
  const bool is_systems = error == EROFS || error == ENOSPC || error == EDQUOT || error == EIO || error == EMFILE ||
                          error == ENFILE || error == ENOMEM;
  const std::string message = path + ": cannot be written: " + std::strerror(error);
  return is_systems ? cannot_finish(message) : bad_input(message);
}

/// A new file beside `place`, with a name that no file has.
int open_beside(const std::string& place, std::string& part) {
  const std::filesystem::path path = place;
  const std::string stem = (folder_of(path) / path.filename().string().substr(0, kStemMax)).string();
  for (int k = 0; k < kTriesMax; ++k) {
    part = stem + ".part-" + std::to_string(::getpid()) + '-' + std::to_string(k);
    const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0 || errno != EEXIST) return file;
  }
  return -1;
}

}  // namespace

Result<OutputFile> OutputFile::create(const std::string& path) {
  OutputFile out;
  out.path_ = path;
  out.place_ = resolved(path).string();
  struct stat old = {};
  const bool exists = ::stat(out.place_.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) return bad_input(path + ": is a folder; name a file");
  if (exists && ::access(out.place_.c_str(), W_OK) != 0) return cannot_open(path, errno);
  out.in_place_ = exists && !S_ISREG(old.st_mode);
  if (out.in_place_) {
    out.part_ = out.place_;
    out.file_ = ::open(out.place_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    out.file_ = open_beside(out.place_, out.part_);
  }
  if (out.file_ < 0) return cannot_open(path, errno);
  if (exists && !out.in_place_) static_cast<void>(::fchmod(out.file_, old.st_mode & 07777));
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
  return *this;
}

OutputFile::~OutputFile() { discard(); }

void OutputFile::discard() {
  if (file_ >= 0) ::close(std::exchange(file_, -1));
  if (!in_place_ && !part_.empty()) ::unlink(part_.c_str());
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

Status OutputFile::commit() {
  if (Status ok = flush(); !ok.ok()) return ok;
  if (::close(std::exchange(file_, -1)) != 0) return failed();
  if (in_place_) return {};
  if (std::rename(part_.c_str(), place_.c_str()) != 0) return failed();
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
