#pragma once

#include <pybind11/pybind11.h>
#include <unistd.h>

#include <chrono>
#include <utility>

#include "tumble/sim/result.h"

/// Errors, locks and interruptions at the border between C++ and Python.
namespace tumble::python {

namespace py = pybind11;

/// Raises tumble.BadInput, tumble.DamagedLog or tumble.CannotFinish. The caller holds Python's lock.
[[noreturn]] void raise(const Error& error);

/// The value of a result, or its error raised.
template <class T>
T take(Result<T> result) {
  if (!result.ok()) raise(result.error());
  return *std::move(result);
}
inline void check(const Status& status) {
  if (!status.ok()) raise(status.error());
}

/// Counts the calls that run without Python's lock. Python ends threads that ask for the lock while it shuts down, and
/// such an end within C++ would end the process; end_calls() therefore comes first.
class RunningCall {
 public:
  RunningCall();
  ~RunningCall();
  RunningCall(const RunningCall&) = delete;
  RunningCall& operator=(const RunningCall&) = delete;
};

/// Makes long calls of other threads end, waits for all, and keeps later ones from beginning. For Python's atexit.
void end_calls();

/// Runs `work` without Python's lock, so that other threads of Python go on meanwhile. `work` must touch no object of
/// Python's.
template <class Work>
auto released(Work&& work) {
  const RunningCall call;
  const py::gil_scoped_release free;
  return std::forward<Work>(work)();
}

/// Deletes an object in the process that made it alone: its threads do not exist in a forked child, and its file is the
/// parent's.
class InOwnProcess {
 public:
  template <class T>
  void operator()(T* object) const {
    if (::getpid() == process_) delete object;
  }

 private:
  pid_t process_ = ::getpid();
};

/// Lets Ctrl-C end a long piece of work that runs without Python's lock.
class Interruption {
 public:
  /// True if Python has a signal to handle whose handler raised, or ends; looks each tenth of a second. The exception
  /// is then Python's current one.
  bool came();

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point looked_ = Clock::now();
};

/// Raises the exception that Interruption saw.
[[noreturn]] inline void raise_interruption() { throw py::error_already_set(); }

}  // namespace tumble::python
