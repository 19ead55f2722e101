// What a log says of every step beside states: times, counters, hashes and inputs.
#include <string>
#include <utility>
#include <vector>

#include "python/binding/arrays.h"
#include "python/binding/log_file.h"
#include "python/binding/values.h"
#include "replay/log/session_clock.h"

namespace tumble::python {
namespace {

/// Calls take(record) for the steps behind the first state, without states.
template <class Take>
void for_each_step(LogFile& log, const Take& take_step) {
  bool interrupted = false;
  check(log.read([&](replay::LogReader& reader) -> Status {
    Interruption interruption;
    for (std::uint64_t k = reader.first_state() + 1; k <= reader.last_step() && !interrupted; ++k) {
      const Result<const replay::StepRecord*> record = reader.read_hashes(k);
      if (!record.ok()) return record.error();
      take_step(**record);
      interrupted = interruption.came();
    }
    return {};
  }));
  if (interrupted) raise_interruption();
}

}  // namespace

py::dict scan_steps(LogFile& log) {
  std::vector<std::uint64_t> step;
  std::vector<std::uint32_t> pairs, contacts, substeps;
  std::vector<double> time, dt, kinetic, potential, inputs, removed;
  std::vector<std::string> hash;
  replay::SessionClock clock;
  for_each_step(log, [&](const replay::StepRecord& record) {
    clock.add_step(record.dt);
    step.push_back(record.step);
    time.push_back(clock.now());
    dt.push_back(record.dt);
    pairs.push_back(record.counters.pairs);
    contacts.push_back(record.counters.contacts);
    substeps.push_back(record.counters.substeps);
    kinetic.push_back(record.counters.kinetic);
    potential.push_back(record.counters.potential);
    inputs.push_back(record.counters.inputs);
    removed.push_back(record.counters.removed);
    hash.push_back(to_string(record.state_hash));
  });
  py::dict columns;
  columns["step"] = array_of(std::move(step));
  columns["time"] = array_of(std::move(time));
  columns["dt"] = array_of(std::move(dt));
  const bool counted = !log.header().engine;  // another engine's recorder tells none of these
  if (counted) {
    columns["pairs"] = array_of(std::move(pairs));
    columns["contacts"] = array_of(std::move(contacts));
    columns["substeps"] = array_of(std::move(substeps));
  }
  columns["kinetic"] = array_of(std::move(kinetic));
  columns["potential"] = array_of(std::move(potential));
  columns["inputs"] = array_of(std::move(inputs));
  if (counted) columns["removed"] = array_of(std::move(removed));
  columns["hash"] = py::cast(hash);
  return columns;
}

py::list read_inputs(LogFile& log) {
  std::vector<std::pair<std::uint64_t, sim::Command>> found;
  for_each_step(log, [&](const replay::StepRecord& record) {
    for (const sim::Command& command : record.inputs) found.emplace_back(record.step, command);
  });
  py::list inputs;
  for (const auto& [step, command] : found) {
    py::dict fields = dict_of(command);
    fields["step"] = step;
    inputs.append(fields);
  }
  return inputs;
}

}  // namespace tumble::python
