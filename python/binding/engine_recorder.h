#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "python/binding/raise.h"
#include "tumble/replay/engine_log.h"

namespace tumble::python {

/// A flag that is set for as long as this lives.
class Busy {
 public:
  explicit Busy(bool& flag) : flag_(flag) { flag_ = true; }
  ~Busy() { flag_ = false; }
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

 private:
  bool& flag_;
};

/// Writes the log of an engine that is written in Python. After an error of the log the steps before can be read, and
/// no call may follow. One thread at a time: a call beside another one raises.
class EngineRecorder {
 public:
  /// about: the keys that tumble/_recorder.py passes. Raises what EngineLog::create() says.
  EngineRecorder(const std::string& path, const py::dict& about);

  void input(const py::dict& fields);
  /// A step from arrays, and from what else it holds.
  void step(const py::dict& fields);
  /// why: the log may have had more steps; empty: it was closed.
  replay::LogSummary finish(const std::string& why);

  [[nodiscard]] std::uint64_t coming_step() const;
  [[nodiscard]] py::array ids() const;
  [[nodiscard]] bool is_finished() const { return finished_; }

 private:
  [[nodiscard]] replay::EngineLog& open() const;
  void refuse_if_busy() const;
  [[nodiscard]] py::array ids_now() const;
  void guard(const Status& status);

  std::string path_;
  std::vector<replay::Channel> channels_;  // ascending names, as the log has them
  std::unique_ptr<replay::EngineLog> log_;
  std::vector<sim::BodyId> removed_;  // by the inputs of the coming step
  bool busy_ = false;                 // a thread of Python is in a call; changed under Python's lock
  bool failed_ = false;
  bool finished_ = false;
};

void add_engine_recorder(py::module_& module);

}  // namespace tumble::python
