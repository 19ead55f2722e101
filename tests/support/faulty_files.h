#pragma once

#include <cstddef>
#include <limits>

/// Files that fail on purpose. A test program linked with --wrap for them (tests/CMakeLists.txt) has the library's
/// calls of open, write, pread, fdatasync, ftruncate and rename pass through here.
namespace tumble::test {

inline constexpr int kNever = std::numeric_limits<int>::max();

/// What goes wrong, and when: calls of a kind are counted from 0. errno values; 0: nothing.
struct FileFaults {
  int open_error = 0;
  int write_error = 0;
  int write_fails_at = kNever;                                      ///< this write and all after it, as on a full disk
  std::size_t write_max = std::numeric_limits<std::size_t>::max();  ///< bytes taken by one write
  int read_error = 0;
  int read_fails_at = kNever;
  int sync_error = 0;
  int sync_fails_at = kNever;
  int rename_error = 0;
  int truncate_error = 0;
  int interrupt_every = kNever;  ///< of the writes, reads and syncs, every n-th is interrupted by a signal first
};

/// Puts faults in force while it lives. One at a time.
class FaultyFiles {
 public:
  explicit FaultyFiles(const FileFaults& wanted);
  ~FaultyFiles();
  FaultyFiles(const FaultyFiles&) = delete;
  FaultyFiles& operator=(const FaultyFiles&) = delete;

  [[nodiscard]] static int writes();  ///< so far
  [[nodiscard]] static int reads();
  [[nodiscard]] static int interruptions();
};

}  // namespace tumble::test
