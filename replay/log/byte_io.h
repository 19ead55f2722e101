#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "tumble/sim/result.h"

/// The destination and the origin of a log's bytes: files, memory (byte_memory.h), and planted faults in tests.
namespace tumble::replay {

/// A destination that bytes are appended to.
class ByteSink {
 public:
  virtual ~ByteSink() = default;

  /// Appends the first bytes of `bytes`, at least one, and returns how many. Errors (kCannotFinish): a full disk and
  /// the like. The message holds the system's reason; the caller adds name().
  virtual Result<std::size_t> write_some(std::span<const std::byte> bytes) = 0;

  /// Removes all bytes from byte `size` on, after a failed write. Does what the system allows and reports nothing.
  virtual void truncate(std::uint64_t size) = 0;

  /// Waits until all written bytes would survive a loss of power.
  virtual Status sync() = 0;

  /// For messages: the path.
  [[nodiscard]] virtual std::string name() const = 0;

  /// True where what was written is discarded unless the log is completed.
  [[nodiscard]] virtual bool whole_or_nothing() const { return false; }
};

/// An origin that bytes are read from, in any order.
class ByteSource {
 public:
  virtual ~ByteSource() = default;

  [[nodiscard]] virtual std::uint64_t size() const = 0;

  /// Fills `bytes` with the bytes from `offset` on. Errors. kDamaged: the source ends before the last of them, as
  /// a file does that shrinks while it is read. kCannotFinish: the system cannot read.
  virtual Status read(std::uint64_t offset, std::span<std::byte> bytes) const = 0;

  /// For messages: the path.
  [[nodiscard]] virtual std::string name() const = 0;

  /// The process that is writing it now, for messages; "" where none is known.
  [[nodiscard]] virtual std::string writer() const { return ""; }
};

/// Opens a log file for writing. The file has its final name from the start, so that after a crash the written chunks
/// are where a reader looks. A log of that name gives way to a new file, so that whoever reads it keeps it. Locks the
/// file until the sink is destroyed or the process ends. Errors. kBadInput: a folder, no permission, a file that is no
/// log, a log that another process writes (the message names the process). kCannotFinish: the disk.
Result<std::unique_ptr<ByteSink>> open_file_sink(const std::string& path);

/// Likewise for a log that has another name until it is complete: `part`, of a files::OutputFile. Messages name `path`.
Result<std::unique_ptr<ByteSink>> open_part_sink(const std::string& part, const std::string& path);

/// Success where open_file_sink() accepts the path: no file, an empty file, a log that nobody writes, or a device.
/// Errors (kBadInput) name what lies there instead: another file, a golden, a log that is being written.
Status may_replace(const std::string& path);

/// Renames a finished file and replaces the file that has the new name. Errors (kCannotFinish) hold both names.
Status rename_file(const std::string& from, const std::string& to);

/// Opens a file for reading. Errors (kBadInput): missing, a folder, no permission.
Result<std::unique_ptr<ByteSource>> open_file_source(const std::string& path);

}  // namespace tumble::replay
