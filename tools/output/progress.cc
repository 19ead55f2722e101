#include "tools/output/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "src/process/interrupt.h"

namespace tumble::tools {
namespace {

constexpr std::chrono::milliseconds kPatience{300};  // a shorter task needs no bar
constexpr std::chrono::milliseconds kInterval{100};
constexpr std::size_t kWidth = 40;

// "8 s", "3 min 20 s", "2 h 5 min": an estimate deserves no more digits.
std::string whole_seconds(double seconds) {
  constexpr std::uint64_t kMinute = 60, kHour = 3600, kMost = 1000 * kHour;
  const auto s = static_cast<std::uint64_t>(std::clamp(std::ceil(seconds), 0.0, static_cast<double>(kMost)));
  if (s < kMinute) return std::to_string(s) + " s";
  if (s < kHour) return std::to_string(s / kMinute) + " min " + std::to_string(s % kMinute) + " s";
  return std::to_string(s / kHour) + " h " + std::to_string(s % kHour / kMinute) + " min";
}

}  // namespace

ProgressBar::ProgressBar(std::string label, bool enabled)
    : label_(std::move(label)),
      enabled_(enabled && isatty(STDERR_FILENO) != 0),
      begin_(Clock::now()),
      next_(begin_ + kPatience) {}

void ProgressBar::finish() {
  if (shown_) std::fputs("\r\033[K", stderr);
  shown_ = false;
}

void ProgressBar::show(std::uint64_t done, std::uint64_t total) {
  if (!enabled_ || total == 0) return;
  const Clock::time_point now = Clock::now();
  if (done < done_) begin_ = now;
  done_ = done;
  if (now < next_) return;
  next_ = now + kInterval;
  shown_ = true;
  const double part = static_cast<double>(done) / static_cast<double>(total);
  const auto filled = static_cast<std::size_t>(part * static_cast<double>(kWidth));
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  std::string left;
  if (done > 0 && done < total) {
    const double so_far = std::chrono::duration<double>(now - begin_).count();
    left = ", about " + whole_seconds(so_far / part * (1 - part)) + " left";
  }
  std::fprintf(stderr, "\r%s [%s] %3.0f %%  step %llu of %llu%s\033[K", label_.c_str(), bar.c_str(), part * 100,
               static_cast<unsigned long long>(done), static_cast<unsigned long long>(total), left.c_str());
  std::fflush(stderr);
}

replay::Progress ProgressBar::progress() {
  return [this](std::uint64_t done, std::uint64_t total) {
    show(done, total);
    return !process::InterruptGuard::interrupted();
  };
}

}  // namespace tumble::tools
