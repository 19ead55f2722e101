#pragma once

#include <sys/types.h>

#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstddef>
#include <string>

namespace tumble::files {

/// While it exists, no signal is handled in this thread, and what another thread handles waits up to a second before it
/// removes names: make and remember a file under one, and no signal finds the file there and its name unknown. Hold it
/// for one system call or a few, and allocate nothing: the handler may have interrupted a thread that allocates.
class NamesHeld {
 public:
  NamesHeld();
  ~NamesHeld();
  NamesHeld(const NamesHeld&) = delete;
  NamesHeld& operator=(const NamesHeld&) = delete;

 private:
  sigset_t before_ = {};
};

/// Names of files or folders that go with this process: what the handler of a signal that ends it removes. At most
/// sixteen at a time; what finds no place stays after a signal.
class EndingNames {
 public:
  /// lock: a descriptor that forget() closes, −1 for none; closed at once where there is no place.
  void remember(const std::string& name, int lock = -1);
  void forget(const std::string& name);  ///< once
  /// Calls `remove` with each name that this process, not one that forked it, remembered and did not forget. From then
  /// on no thread makes further ones: each waits in NamesHeld for the end of the process. For the handler of a signal.
  void remove_all(void (*remove)(const char* name));

 private:
  struct Row {
    enum State : int { kFree, kTaken, kNamed };
    std::atomic<int> state = kFree;
    std::atomic<std::size_t> key = 0;  // of the name
    pid_t process = 0;
    int lock = -1;
    std::array<char, PATH_MAX> name = {};
  };
  std::array<Row, 16> rows_;
};

}  // namespace tumble::files
