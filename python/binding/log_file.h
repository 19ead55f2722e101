#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python/binding/raise.h"
#include "replay/session/state_source.h"
#include "replay/view/contact_points.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"

namespace tumble::python {

/// The states of a step in memory that arrays share: row by row, so that n × 3 numbers are one array of numpy.
struct StateBlock {
  std::vector<std::uint64_t> id;
  std::vector<double> position;     // n × 3, m
  std::vector<double> orientation;  // n × 4, w x y z
  std::vector<double> velocity;     // n × 3, m/s
  std::vector<double> spin;         // n × 3, rad/s
  std::vector<std::uint8_t> frozen;
};
StateBlock block_of(const replay::BodyStates& states);

/// A step of a log, read and kept: it needs the log no longer, but for states and contacts that are computed.
struct StepData {
  replay::StepRecord record;           // without its states
  std::shared_ptr<StateBlock> states;  // null: not yet computed
};

/// A log that several threads of Python may read.
class LogFile {
 public:
  /// Raises what LogReader::open() says, and tumble.DamagedLog for a log that was torn before its first state.
  explicit LogFile(const std::string& path);

  /// Runs work(reader) without Python's lock and returns what it returns. Raises tumble.BadInput once closed.
  template <class Work>
  auto read(Work&& work) -> decltype(work(std::declval<replay::LogReader&>())) {
    return checked(released([&]() -> std::optional<decltype(work(std::declval<replay::LogReader&>()))> {
      const std::scoped_lock lock(mutex_);
      if (!reader_) return std::nullopt;
      return work(*reader_);
    }));
  }

  StepData step(std::uint64_t k);
  /// The states of step k, computed where the log does not hold them.
  std::shared_ptr<StateBlock> states(std::uint64_t k);
  std::vector<replay::ContactPoint> contacts(std::uint64_t k);
  /// A source of states for work inside read().
  replay::StateSource& source() { return *source_; }

  void close();
  [[nodiscard]] bool is_closed() const { return closed_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  // Of the open log; none of it changes.
  [[nodiscard]] const replay::LogHeader& header() const { return header_; }
  [[nodiscard]] std::uint64_t first() const { return first_; }
  [[nodiscard]] std::uint64_t last() const { return last_; }

 private:
  template <class Value>
  Value checked(std::optional<Value> value) {
    if (!value) raise_closed();
    return *std::move(value);
  }
  [[noreturn]] void raise_closed() const;

  std::string path_;
  std::mutex mutex_;  // locked without Python's lock alone
  std::optional<replay::LogReader> reader_;
  std::optional<replay::StateSource> source_;
  std::optional<replay::ContactSource> contacts_;
  replay::LogHeader header_;
  std::uint64_t first_ = 0, last_ = 0;
  bool closed_ = false;
};

/// Adds the class to the module: see tumble/_log.py for what is made of it.
void add_log(py::module_& module);
void add_step(py::module_& module);

// Arrays over many steps; log_columns.cc and log_scan.cc.
py::array read_column(LogFile& log, const std::string& column, std::uint64_t first, std::uint64_t count,
                      std::int64_t stride, const py::object& ids);
py::dict scan_steps(LogFile& log);
py::list read_inputs(LogFile& log);
py::dict channel_rows(LogFile& log, std::size_t channel, std::uint64_t first, std::uint64_t count, std::int64_t stride);
py::dict header_dict(const LogFile& log);
py::dict bodies_dict(LogFile& log);

}  // namespace tumble::python
