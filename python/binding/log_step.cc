// A step of a log in Python: arrays over its states, inputs, hashes, and what an engine logged beside them.
#include <array>

#include "python/binding/arrays.h"
#include "python/binding/log_file.h"
#include "python/binding/values.h"

namespace tumble::python {
namespace {

/// The number of bodies of a block, as numpy counts.
py::ssize_t rows(const StateBlock& block) { return static_cast<py::ssize_t>(block.id.size()); }

/// Without those that the log of another engine does not tell.
py::dict counters_of(const sim::StepCounters& counters, const LogFile& log) {
  const bool counted = !log.header().engine;
  py::dict fields;
  if (counted) {
    fields["pairs"] = counters.pairs;
    fields["contacts"] = counters.contacts;
    fields["substeps"] = counters.substeps;
  }
  fields["kinetic"] = counters.kinetic;
  fields["potential"] = counters.potential;
  fields["inputs"] = counters.inputs;
  if (counted) fields["removed"] = counters.removed;
  return fields;
}

py::list inputs_of(const StepData& step) {
  py::list inputs;
  for (const sim::Command& command : step.record.inputs) inputs.append(dict_of(command));
  return inputs;
}

py::array phase_words(const StepData& step, std::size_t phases) {
  const std::vector<std::uint64_t>& words = step.record.phase_words;
  const std::size_t columns = phases == 0 ? 1 : phases;
  return array_of(words, {static_cast<py::ssize_t>(words.size() / columns), static_cast<py::ssize_t>(phases)});
}

/// [((a, b), value), …]
py::list channel_of(const StepData& step, std::size_t channel, const LogFile& log) {
  const std::vector<replay::Channel>& channels = log.header().declared.channels;
  const replay::ChannelValues& values = step.record.extras.values(channel);
  py::list all;
  for (std::size_t row = 0; row < values.size(); ++row) {
    const replay::ChannelKind kind = channels.at(channel).type.kind;
    all.append(py::make_tuple(values.keys[row].a, values.keys[row].b, object_of(values.value(row, kind), kind)));
  }
  return all;
}

/// As the engine logged them; none of ours. [(a, b or None for the world, position, normal, depth, impulse), …]
py::list contacts_of_engine(const StepData& step) {
  py::list all;
  for (const replay::EngineContact& contact : step.record.extras.contacts) {
    const py::object b = contact.b == 0 ? py::object(py::none()) : py::object(py::int_(contact.b));
    all.append(py::make_tuple(contact.a, b, tuple_of(contact.position), tuple_of(contact.normal), contact.depth,
                              contact.impulse));
  }
  return all;
}

py::list texts_of(const std::vector<std::string>& texts) {
  py::list all;
  for (const std::string& text : texts) all.append(text_of_bytes(text));
  return all;
}

py::list snapshots_of(const StepData& step) {
  py::list all;
  for (const replay::EngineSnapshot& snapshot : step.record.extras.snapshots) all.append(py::bytes(snapshot.bytes));
  return all;
}

py::list snapshot_names_of(const StepData& step) {
  py::list all;
  for (const replay::EngineSnapshot& snapshot : step.record.extras.snapshots) all.append(text_of_bytes(snapshot.name));
  return all;
}

/// (whether inputs and start were the same, the first difference)
py::list superseded_of(const StepData& step) {
  py::list all;
  for (const replay::Superseded& before : step.record.extras.superseded) {
    all.append(py::make_tuple(before.same_inputs, text_of_bytes(before.difference)));
  }
  return all;
}

void add_block(py::module_& module) {
  using Block = std::shared_ptr<StateBlock>;
  py::class_<StateBlock, Block>(module, "StateBlock")
      .def_property_readonly("ids", [](const Block& b) { return view_of(b, b->id.data(), {rows(*b)}); })
      .def_property_readonly("position",
                             [](const Block& b) {
                               return view_of(b, b->position.data(), {rows(*b), 3});
                             })
      .def_property_readonly("orientation",
                             [](const Block& b) {
                               return view_of(b, b->orientation.data(), {rows(*b), 4});
                             })
      .def_property_readonly("velocity",
                             [](const Block& b) {
                               return view_of(b, b->velocity.data(), {rows(*b), 3});
                             })
      .def_property_readonly("spin",
                             [](const Block& b) {
                               return view_of(b, b->spin.data(), {rows(*b), 3});
                             })
      .def_property_readonly(
          "frozen", [](const Block& b) { return view_of(b, b->frozen.data(), {rows(*b)}).attr("view")("bool"); });
}

}  // namespace

void add_step(py::module_& module) {
  add_block(module);
  py::class_<StepData>(module, "StepData")
      .def_property_readonly("step", [](const StepData& s) { return s.record.step; })
      .def_property_readonly("dt", [](const StepData& s) { return s.record.dt; })
      .def_property_readonly("hash", [](const StepData& s) { return to_string(s.record.state_hash); })
      .def_property_readonly("states", [](const StepData& s) { return s.states; })
      .def("counters", [](const StepData& s, const LogFile& log) { return counters_of(s.record.counters, log); })
      .def("inputs", &inputs_of)
      .def("phase_words", &phase_words)
      .def("channel", &channel_of)
      .def("contacts", &contacts_of_engine)
      .def("notes", [](const StepData& s) { return texts_of(s.record.extras.notes); })
      .def("snapshots", &snapshots_of)
      .def("snapshot_names", &snapshot_names_of)
      .def("superseded", &superseded_of);
}

}  // namespace tumble::python
