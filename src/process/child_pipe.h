#pragma once

#include <sys/types.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/sim/result.h"

namespace tumble::process {

/// Another program that runs beside and reads our output from its standard input.
class ChildPipe {
 public:
  ChildPipe() = default;
  ~ChildPipe() { abandon(); }
  ChildPipe(const ChildPipe&) = delete;
  ChildPipe& operator=(const ChildPipe&) = delete;

  /// Starts words[0] with the other words as its arguments; it is looked for in PATH. Errors (kCannotFinish): it is not
  /// installed (purpose says what needs it, package how to get it), or does not start. errors: a file that its standard
  /// error is added to; empty: ours. Precondition: it does not run.
  Status start(std::vector<std::string> words, const std::string& purpose, const std::string& package,
               const std::string& errors = "");

  [[nodiscard]] bool running() const { return child_ > 0; }

  /// False when the program reads no more.
  [[nodiscard]] bool write(std::span<const std::byte> bytes) const;

  /// Closes the pipe and waits. True if the program ended well.
  bool finish();

  /// Ends the program, if it runs.
  void abandon();

 private:
  pid_t child_ = -1;
  int pipe_ = -1;
};

/// The last line that a program which failed wrote to its standard error, for the end of a message: ": out of memory",
/// or the likeliest cause where it wrote none.
std::string last_words(std::string_view said);

}  // namespace tumble::process
