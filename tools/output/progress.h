#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "tumble/replay/progress.h"

namespace tumble::tools {

/// A progress bar on stderr: only on a terminal, only for a task that takes longer than a moment, and gone afterwards.
/// Debian 12 has no C++ library for one.
class ProgressBar {
 public:
  /// label: names the task, "recording".
  explicit ProgressBar(std::string label, bool enabled = true);
  ~ProgressBar() { finish(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Another pass of the same task begins where `done` falls: time is then estimated anew.
  void show(std::uint64_t done, std::uint64_t total);
  /// Shows each call, and answers whether to go on: false once an InterruptGuard was interrupted.
  [[nodiscard]] replay::Progress progress();
  void finish();  ///< removes the bar; to be called before results are printed

 private:
  using Clock = std::chrono::steady_clock;

  std::string label_;
  bool enabled_;
  bool shown_ = false;
  std::uint64_t done_ = 0;
  Clock::time_point begin_, next_;
};

}  // namespace tumble::tools
