#include "tumble/replay/byte_io.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "src/files/file_identity.h"
#include "src/files/file_lock.h"
#include "src/files/output_file.h"
#include "src/files/part_file.h"
#include "tumble/replay/prelude.h"

namespace tumble::replay {
namespace {

/// The most bytes of one write; systems accept no more than 2 GiB (Linux).
constexpr std::size_t kWriteMax = 1 << 30;

std::string reason() { return std::strerror(errno); }

class File {
 public:
  explicit File(int descriptor) : descriptor_(descriptor) {}
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  File(File&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  File& operator=(File&&) = delete;
  [[nodiscard]] int get() const { return descriptor_; }
  [[nodiscard]] bool ok() const { return descriptor_ >= 0; }

 private:
  int descriptor_;
};

/// The error for a log that another writer has locked.
Status locked(const std::string& path, int file) {
  const std::string holder = files::holder_of(file);
  const std::string who = holder.empty() ? "another recorder" : holder;
  return bad_input(path + ": is being written by " + who + "; wait until it ends, or name another file");
}

class FileSink : public ByteSink {
 public:
  FileSink(File file, std::string path, bool is_part)
      : file_(std::move(file)), path_(std::move(path)), is_part_(is_part) {}

  Result<std::size_t> write_some(std::span<const std::byte> bytes) override {
    for (;;) {
      const ssize_t written = ::write(file_.get(), bytes.data(), std::min(bytes.size(), kWriteMax));
      if (written > 0) return static_cast<std::size_t>(written);
      if (written == 0) return cannot_finish("the file takes no more bytes");
      if (errno != EINTR) return cannot_finish(reason());
    }
  }
  void truncate(std::uint64_t size) override {
    const auto end = static_cast<off_t>(size);
    if (::ftruncate(file_.get(), end) == 0) ::lseek(file_.get(), end, SEEK_SET);
  }
  Status sync() override {
    for (;;) {
      if (::fdatasync(file_.get()) == 0 || errno == EINVAL || errno == EROFS) return {};  // not a file on a disk
      if (errno != EINTR) return cannot_finish(reason());
    }
  }
  std::string name() const override { return path_; }
  bool whole_or_nothing() const override { return is_part_; }

 private:
  File file_;
  std::string path_;
  bool is_part_;
};

class FileSource : public ByteSource {
 public:
  FileSource(File file, std::uint64_t size, std::string path)
      : file_(std::move(file)), size_(size), path_(std::move(path)) {}

  std::uint64_t size() const override { return size_; }
  Status read(std::uint64_t offset, std::span<std::byte> bytes) const override {
    while (!bytes.empty()) {
      const ssize_t got = ::pread(file_.get(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return cannot_finish(path_ + ": cannot read at byte " + std::to_string(offset) + ": " + reason());
      if (got == 0) {
        return damaged(path_ + ": the file ends at byte " + std::to_string(offset) + ", before the " +
                       std::to_string(bytes.size()) + " bytes wanted there");
      }
      bytes = bytes.subspan(static_cast<std::size_t>(got));
      offset += static_cast<std::uint64_t>(got);
    }
    return {};
  }
  std::string name() const override { return path_; }
  std::string writer() const override { return files::holder_of(file_.get()); }

 private:
  File file_;
  std::uint64_t size_;
  std::string path_;
};

}  // namespace

/// Protects files that are no logs: a slip of the command line must not replace a scene or a golden.
Status may_replace(const std::string& path) {
  struct stat info = {};
  if (::stat(path.c_str(), &info) != 0) return {};
  if (S_ISDIR(info.st_mode)) return bad_input(path + ": is a folder; name a file to write the log to");
  if (!S_ISREG(info.st_mode)) return {};
  const File file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (file.ok() && !files::lock(file.get())) return locked(path, file.get());
  if (info.st_size == 0) return {};
  std::array<std::byte, kPreludeBytes> start = {};
  const ssize_t got = file.ok() ? ::pread(file.get(), start.data(), start.size(), 0) : 0;
  const std::span<const std::byte> found = std::span(start).first(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  if (found.empty() || !starts_like_log(found.first(std::min(found.size(), kMagicEnd)))) {
    return bad_input(path + ": exists and is not a log; choose another name or remove it first");
  }
  const Result<Prelude> prelude = decode_prelude(start);
  if (!prelude.ok() || prelude->kind != RecordKind::kGolden) return {};
  return bad_input(path + ": is a golden, which nothing but bless replaces; choose another name");
}

Status rename_file(const std::string& from, const std::string& to) {
  if (std::rename(from.c_str(), to.c_str()) == 0) return {};
  return cannot_finish(to + ": cannot be put in place: " + reason() + "; what was to be there is in " + from);
}

namespace {

Error nameless() { return bad_input("found an empty name, wanted the file of a log"); }

/// A new, empty, locked file in the place of a log: whoever reads the old one keeps it. Where the folder takes no new
/// file, the old one is emptied.
Result<File> replaced(File old, const std::string& path, mode_t mode) {
  std::string part;
  const std::string place = files::resolved(path).string();
  File fresh(files::open_part(place, part));
  if (!fresh.ok()) {
    if (::ftruncate(old.get(), 0) != 0) return cannot_finish(path + ": cannot be emptied: " + reason());
    return old;
  }
  static_cast<void>(::fchmod(fresh.get(), mode));
  const bool in_place = files::lock(fresh.get()) && std::rename(part.c_str(), place.c_str()) == 0;
  const std::string why = reason();
  if (!in_place) ::unlink(part.c_str());
  files::forget_part(part);
  if (in_place) return fresh;
  return cannot_finish(path + ": cannot be replaced: " + why);
}

Result<File> open_log(const std::string& path) {
  if (path.empty()) return nameless();
  if (Status ok = may_replace(path); !ok.ok()) return ok.error();
  // Replaced once it is locked: until then it may be the log of another process.
  File file(files::open_to_write(path, O_CREAT));
  if (!file.ok()) return files::cannot_open(path, errno);
  struct stat info = {};
  if (::fstat(file.get(), &info) != 0 || !S_ISREG(info.st_mode)) return file;
  if (!files::lock(file.get())) return locked(path, file.get()).error();
  if (files::identity_of(path) != files::FileIdentity{info.st_dev, info.st_ino}) {
    return bad_input(path + ": was replaced by another process just now; try again, or name another file");
  }
  if (info.st_size == 0) return file;
  return replaced(std::move(file), path, info.st_mode & 07777);
}

}  // namespace

Result<std::unique_ptr<ByteSink>> open_file_sink(const std::string& path) {
  Result<File> file = open_log(path);
  if (!file.ok()) return file.error();
  return std::unique_ptr<ByteSink>(std::make_unique<FileSink>(*std::move(file), path, false));
}

Result<std::unique_ptr<ByteSink>> open_part_sink(const std::string& part, const std::string& path) {
  Result<File> file = open_log(part);
  if (!file.ok()) return file.error();
  return std::unique_ptr<ByteSink>(std::make_unique<FileSink>(*std::move(file), path, true));
}

Result<std::unique_ptr<ByteSource>> open_file_source(const std::string& path) {
  if (path.empty()) return nameless();
  // A named pipe lets nobody open it to read before somebody writes, however long that takes.
  File file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!file.ok()) return bad_input(path + ": cannot be opened: " + reason());
  struct stat info = {};
  if (::fstat(file.get(), &info) != 0) return bad_input(path + ": cannot be opened: " + reason());
  if (S_ISDIR(info.st_mode)) return bad_input(path + ": is a folder, not a log");
  if (!S_ISREG(info.st_mode)) return bad_input(path + ": is no file, but a pipe or a device; name the file of a log");
  const auto size = static_cast<std::uint64_t>(info.st_size);
  return std::unique_ptr<ByteSource>(std::make_unique<FileSource>(std::move(file), size, path));
}

}  // namespace tumble::replay
