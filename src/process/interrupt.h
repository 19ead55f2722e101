#pragma once

namespace tumble::process {

/// While one of these lives, Ctrl-C sets a flag instead of ending the program, so that a log can be completed first.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  [[nodiscard]] static bool interrupted();
};

}  // namespace tumble::process
