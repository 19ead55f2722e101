#include "tools/output/progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace tumble::tools {
namespace {

constexpr std::chrono::milliseconds kPatience{300};  // a shorter task needs no bar
constexpr std::chrono::milliseconds kInterval{100};
constexpr std::size_t kWidth = 40;

}  // namespace

ProgressBar::ProgressBar(std::string label, bool enabled)
    : label_(std::move(label)), enabled_(enabled && isatty(STDERR_FILENO) != 0), next_(Clock::now() + kPatience) {}

void ProgressBar::finish() {
  if (shown_) std::fputs("\r\033[K", stderr);
  shown_ = false;
}

void ProgressBar::show(std::uint64_t done, std::uint64_t total) {
  if (!enabled_ || total == 0) return;
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + kInterval;
  shown_ = true;
  const double part = static_cast<double>(done) / static_cast<double>(total);
  const auto filled = static_cast<std::size_t>(part * static_cast<double>(kWidth));
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  std::fprintf(stderr, "\r%s [%s] %3.0f %%  step %llu of %llu\033[K", label_.c_str(), bar.c_str(), part * 100,
               static_cast<unsigned long long>(done), static_cast<unsigned long long>(total));
  std::fflush(stderr);
}

}  // namespace tumble::tools
