#pragma once

#include <chrono>
#include <ostream>
#include <string>
#include <string_view>

namespace tumble::tools::bisect {

/// The last counter of ninja ("[12/260]") or make ("[ 12%]") at the start of a line; empty if there is none.
std::string last_counter(std::string_view output);

/// The line of a build's output that says why it failed: the first error of a compiler, linker or CMake (whose text
/// stands in the lines below), else the last line that is not blank. Empty if there is none.
std::string failure_in(std::string_view output);

/// "45 s", "2 min 5 s".
std::string elapsed_text(std::chrono::seconds elapsed);

/// Shows how far a build is while it runs, and how long it has taken so far: on a terminal in one line that is written
/// anew and taken away at the end, elsewhere in a line a minute.
class BuildProgress {
 public:
  using Clock = std::chrono::steady_clock;

  /// Where to show it and how often. out must outlive the progress.
  struct Display {
    std::ostream& out;
    bool is_terminal;
    Clock::duration interval;
  };
  static Display on_stderr();

  /// log: the file that the build's output goes to
  explicit BuildProgress(std::string log, const Display& display = on_stderr());
  ~BuildProgress() { finish(); }
  BuildProgress(const BuildProgress&) = delete;
  BuildProgress& operator=(const BuildProgress&) = delete;

  /// To be called many times a second; writes when a line is due.
  void show();

  void finish();

 private:
  std::string log_;
  Display display_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point next_;
  bool is_shown_ = false;
};

}  // namespace tumble::tools::bisect
