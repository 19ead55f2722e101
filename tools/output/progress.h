#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace tumble::tools {

/// A bar on stderr while something takes its time: only on a terminal, only where it takes longer than a moment, and
/// gone afterwards. Debian 12 has no C++ library for one.
class ProgressBar {
 public:
  /// label: what is being done, "recording".
  explicit ProgressBar(std::string label, bool enabled = true);
  ~ProgressBar() { finish(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::uint64_t done, std::uint64_t total);
  void finish();  ///< takes the bar away; before results are printed

 private:
  using Clock = std::chrono::steady_clock;

  std::string label_;
  bool enabled_;
  bool shown_ = false;
  Clock::time_point next_;
};

}  // namespace tumble::tools
