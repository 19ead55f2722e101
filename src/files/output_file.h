#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "tumble/sim/result.h"

namespace tumble::files {

/// Opens a file for writing, with these flags of open() besides. A pipe that nothing reads is an error, ENXIO, at once:
/// to wait for a reader may take for ever, and no interruption ends that.
int open_to_write(const std::string& place, int flags);

/// The error for a file that cannot be opened for writing, from errno: kCannotFinish where the disk or a limit of the
/// system is at fault, else kBadInput.
Error cannot_open(const std::string& path, int error);

/// Asked before work whose results go into a folder that is there; the error names the path, which is the folder itself
/// or what shall lie in it. Errors: as cannot_open().
Status can_write_in(const std::string& folder, const std::string& path);

/// Asked before work whose result goes into a file in a folder that is there: whether rights allow it. Touches nothing;
/// the error names the file as `named`, or by its path. Errors (kBadInput): a folder, no permission, no such folder.
Status may_write(const std::string& path, const std::string& named = {});

/// Writes a file under a name of its own in the same folder and renames it when it is complete. A full disk, a failure
/// or a crash leaves the old file as it was. A path that leads through symbolic links replaces the file they lead to.
/// Only regular files are replaced: a device or a pipe is written to as it is.
///
/// Errors. kBadInput: no such folder, a folder, no permission. kCannotFinish: the disk.
class OutputFile {
 public:
  static Result<OutputFile> create(const std::string& path);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&& other) noexcept;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();  ///< without commit(): discards what was written

  /// The file that is there until commit(), for a program that writes to a file by its name.
  [[nodiscard]] const std::string& part() const { return part_; }

  /// True for a device or a pipe, which cannot be read back.
  [[nodiscard]] bool is_device() const { return in_place_; }

  Status write(std::string_view bytes);

  /// Writes at a place of its own, behind which the file may still have holes. Precondition (SIM_CHECK): no device.
  Status write_at(std::uint64_t place, std::string_view bytes);

  /// Gives the file its name. Call once, as the last call.
  Status commit();

 private:
  OutputFile() = default;
  [[nodiscard]] Error failed() const;
  Status flush();
  [[nodiscard]] Status sync() const;
  void discard();

  std::string path_;   // as the user named it
  std::string place_;  // behind symbolic links
  std::string part_;
  std::string buffer_;
  int file_ = -1;
  bool in_place_ = false;  // a device or a pipe
  bool replaces_ = false;  // a regular file that is there
};

/// A small file at once.
Status write_whole_file(const std::string& path, std::string_view content);

}  // namespace tumble::files
