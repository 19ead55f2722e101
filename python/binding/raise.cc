#include "python/binding/raise.h"

#include <atomic>
#include <thread>

namespace tumble::python {
namespace {

const char* class_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::kBadInput:
      return "BadInput";
    case ErrorKind::kDamaged:
      return "DamagedLog";
    case ErrorKind::kCannotFinish:
      return "CannotFinish";
  }
  return "CannotFinish";
}

std::atomic<bool> python_ends = false;
std::atomic<int> running_calls = 0;  // changed under Python's lock

}  // namespace

RunningCall::RunningCall() {
  if (python_ends) {
    PyErr_SetString(PyExc_SystemExit, "Python is shutting down");
    throw py::error_already_set();
  }
  ++running_calls;
}

RunningCall::~RunningCall() { --running_calls; }

void end_calls() {
  constexpr std::chrono::milliseconds kInterval{5};
  python_ends = true;
  const py::gil_scoped_release free;
  while (running_calls > 0) std::this_thread::sleep_for(kInterval);
}

void raise(const Error& error) {
  const py::object type = py::module_::import("tumble._errors").attr(class_of(error.kind));
  // A message may hold any bytes of a path or a log.
  const py::object text = py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(error.message.data(), static_cast<Py_ssize_t>(error.message.size()), "backslashreplace"));
  if (!text) throw py::error_already_set();
  PyErr_SetObject(type.ptr(), text.ptr());
  throw py::error_already_set();
}

bool Interruption::came() {
  constexpr std::chrono::milliseconds kInterval{100};
  const Clock::time_point now = Clock::now();
  if (now - looked_ < kInterval) return false;
  looked_ = now;
  const py::gil_scoped_acquire lock;
  if (python_ends) {
    PyErr_SetString(PyExc_SystemExit, "Python is shutting down");
    return true;
  }
  return PyErr_CheckSignals() != 0;
}

}  // namespace tumble::python
