#include "src/process/interrupt.h"

#include <csignal>

namespace tumble::process {
namespace {

volatile std::sig_atomic_t signal_came = 0;

void note_signal(int /*number*/) { signal_came = 1; }

}  // namespace

InterruptGuard::InterruptGuard() {
  signal_came = 0;
  std::signal(SIGINT, note_signal);
  std::signal(SIGTERM, note_signal);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool InterruptGuard::interrupted() { return signal_came != 0; }

}  // namespace tumble::process
