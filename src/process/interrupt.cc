#include "src/process/interrupt.h"

#include <unistd.h>

#include <algorithm>
#include <cstddef>

#include "src/base/check.h"

namespace tumble::process {
namespace {

constexpr std::array kInterrupts = {SIGINT, SIGTERM, SIGHUP};
static_assert(kInterrupts.size() == SignalHandlers{}.size());

volatile std::sig_atomic_t signal_came;  // cleared by each guard

void note_signal(int /*number*/) { signal_came = 1; }

// What the handler of InterruptExit reads: nothing that it would have to build.
struct Ending {
  std::array<char, 256> line = {};
  std::size_t size = 0;
  int status = 0;
  void (*clean_up)() = nullptr;
};
Ending ending;

void end_program(int /*number*/) {
  ending.clean_up();
  const ssize_t ignored = ::write(STDERR_FILENO, ending.line.data(), ending.size);
  static_cast<void>(ignored);
  ::_exit(ending.status);
}

void handle(void (*handler)(int), SignalHandlers& before) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < kInterrupts.size(); ++i) {
    ::sigaction(kInterrupts[i], nullptr, &before[i]);
    if (before[i].sa_handler != SIG_IGN) ::sigaction(kInterrupts[i], &action, nullptr);
  }
}

void give_back(const SignalHandlers& before) {
  for (std::size_t i = 0; i < kInterrupts.size(); ++i) ::sigaction(kInterrupts[i], &before[i], nullptr);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  signal_came = 0;
  handle(note_signal, before_);
}

InterruptGuard::~InterruptGuard() { give_back(before_); }

bool InterruptGuard::interrupted() { return signal_came != 0; }

InterruptExit::InterruptExit(const std::string& line, int status, void (*clean_up)()) {
  SIM_CHECK(ending.clean_up == nullptr);
  ending.size = std::min(line.size(), ending.line.size() - 1);
  std::copy_n(line.begin(), ending.size, ending.line.begin());
  ending.line[ending.size++] = '\n';
  ending.status = status;
  ending.clean_up = clean_up;
  handle(end_program, before_);
}

InterruptExit::~InterruptExit() {
  give_back(before_);
  ending.clean_up = nullptr;
}

}  // namespace tumble::process
