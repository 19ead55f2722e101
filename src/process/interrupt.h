#pragma once

#include <array>
#include <csignal>
#include <string>

namespace tumble::process {

/// What Ctrl-C, SIGTERM and SIGHUP did before.
using SignalHandlers = std::array<struct sigaction, 3>;

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
  SignalHandlers before_ = {};
};

/// While it exists and no guard does, these signals end the program: they clean up, print a line on standard error, and
/// exit with a status. A signal that the caller ignores stays ignored. One at a time (SIM_CHECK).
class InterruptExit {
 public:
  /// clean_up: does what POSIX allows in the handler of a signal.
  InterruptExit(const std::string& line, int status, void (*clean_up)());
  ~InterruptExit();
  InterruptExit(const InterruptExit&) = delete;
  InterruptExit& operator=(const InterruptExit&) = delete;

 private:
  SignalHandlers before_ = {};
};

}  // namespace tumble::process
