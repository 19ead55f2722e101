#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "src/base/result.h"

namespace tumble::tools {

/// Another program to be run to its end.
struct ChildTask {
  std::vector<std::string> words;           ///< the program, looked for in PATH, and its arguments; no shell sees them
  std::string folder;                       ///< to run in; empty: the current one
  std::string out;                          ///< file for its standard output
  std::string err;                          ///< file for its standard error; may be the same one
  double timeout_s = 0;                     ///< it is ended after that long; 0: never
  std::map<std::string, std::string> more;  ///< environment, unless it has them
};

/// How it ended.
struct ChildEnd {
  int exit = -1;         ///< -1 if a signal ended it
  int signal = 0;        ///< that ended it
  bool stopped = false;  ///< by us, because `cancel` said so
  bool late = false;     ///< by us, because it took too long
  [[nodiscard]] bool well() const { return exit == 0; }
  [[nodiscard]] std::string text() const;  ///< "ended with status 1", "was ended by SIGSEGV"
};

/// Runs it in a process group of its own, which gets SIGTERM, and SIGKILL if that does not help, as soon as `cancel`
/// (asked many times a second; may be empty) says so. Variables by which git finds its repository are not passed on.
/// Errors (kCannotFinish): it does not start, files that cannot be written.
Result<ChildEnd> run_child(const ChildTask& task, const std::function<bool()>& cancel = {});

/// A command line taken apart at spaces, as a shell does with quotes and backslashes and nothing else. Errors
/// (kBadInput): a quote without its end, no word.
Result<std::vector<std::string>> split_words(const std::string& command);

}  // namespace tumble::tools
