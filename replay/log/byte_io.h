#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "src/base/result.h"

/// Where a log's bytes go to and come from. Files in the program; memory and faults on purpose in tests.
namespace tumble::replay {

class ByteSink {
 public:
  virtual ~ByteSink() = default;

  /// Appends some of `bytes`, at least one, and returns how many. Errors (kCannotFinish): a full disk and the like; the
  /// message has the system's reason and not the name, which name() gives.
  virtual Result<std::size_t> write_some(std::span<const std::byte> bytes) = 0;

  /// Cuts everything from `size` on, after a failed write. Best effort.
  virtual void truncate(std::uint64_t size) = 0;

  /// Returns when what was written will outlive a loss of power.
  virtual Status sync() = 0;

  /// For messages: the path.
  [[nodiscard]] virtual std::string name() const = 0;
};

class ByteSource {
 public:
  virtual ~ByteSource() = default;

  [[nodiscard]] virtual std::uint64_t size() const = 0;

  /// Fills `bytes` from `offset` on. Errors: the range is not inside the source (kDamaged: a file that shrank while it
  /// was read), a read that fails (kCannotFinish).
  virtual Status read(std::uint64_t offset, std::span<std::byte> bytes) const = 0;

  /// For messages: the path.
  [[nodiscard]] virtual std::string name() const = 0;
};

/// Opens a log file for writing, under its final name: a crash must leave the chunks written so far where they are
/// looked for. A log there is replaced. Errors: kBadInput (a folder, no permission, no log), kCannotFinish (the disk).
Result<std::unique_ptr<ByteSink>> open_file_sink(const std::string& path);

/// Whether open_file_sink() would accept the path: nothing is there, or an empty file, a log or a device. Errors
/// (kBadInput) say what is there.
Status may_replace(const std::string& path);

/// Gives a finished file its final name, in place of what had it. Errors (kCannotFinish), with both names.
Status rename_file(const std::string& from, const std::string& to);

/// Opens a file for reading. Errors (kBadInput): missing, a folder, no permission.
Result<std::unique_ptr<ByteSource>> open_file_source(const std::string& path);

}  // namespace tumble::replay
