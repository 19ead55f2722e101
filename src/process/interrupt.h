#pragma once

namespace tumble::process {

/// While a guard exists, Ctrl-C and SIGTERM set a flag instead of ending the program, so that a log can be completed.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  [[nodiscard]] static bool interrupted();
};

}  // namespace tumble::process
