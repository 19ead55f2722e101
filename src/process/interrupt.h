#pragma once

#include <array>
#include <csignal>

namespace tumble::process {

/// While a guard exists, Ctrl-C, SIGTERM and SIGHUP set a flag instead of ending the program, so that a log can be
/// completed. A signal that the caller ignores stays ignored (nohup, a shell's background job).
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  [[nodiscard]] static bool interrupted();

 private:
  static constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, kSignals.size()> before_ = {};
};

}  // namespace tumble::process
