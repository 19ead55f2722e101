// A step of an engine in Python: arrays, channels, contacts and the rest, checked before any of it reaches the log.
#include <algorithm>
#include <optional>
#include <utility>

#include "python/binding/arrays.h"
#include "python/binding/engine_recorder.h"
#include "python/binding/values.h"
#include "replay/format/limits.h"
#include "src/base/text.h"

namespace tumble::python {
namespace {

/// The states of a step as the caller gave them; columns that are left out stay as they were.
struct Told {
  std::vector<sim::BodyId> ids;
  std::vector<double> position, velocity;
  std::optional<std::vector<double>> orientation, spin;
  std::vector<std::uint8_t> frozen;
};

bool has(const py::dict& fields, const char* key) { return fields.contains(key) && !fields[key].is_none(); }

Told told_of(const py::dict& fields, const py::array& all_ids) {
  Told told;
  told.ids = ids_of(has(fields, "ids") ? py::object(fields["ids"]) : py::object(all_ids), "ids");
  const std::size_t n = told.ids.size();
  for (const char* name : {"position", "velocity"}) {
    if (!has(fields, name)) raise(bad_input(std::string(name) + ": is missing; every step needs it"));
  }
  told.position = doubles_of(fields["position"], "position", n, 3);
  told.velocity = doubles_of(fields["velocity"], "velocity", n, 3);
  if (has(fields, "orientation")) told.orientation = doubles_of(fields["orientation"], "orientation", n, 4);
  if (has(fields, "spin")) told.spin = doubles_of(fields["spin"], "spin", n, 3);
  told.frozen.assign(n, 0);
  if (!has(fields, "frozen")) return told;
  const py::object frozen = fields["frozen"];
  if (!py::isinstance<py::sequence>(frozen) || py::len(frozen) != n) {
    raise(bad_input("frozen: wanted " + std::to_string(n) + " flags"));
  }
  for (std::size_t i = 0; i < n; ++i) told.frozen[i] = flag_of(frozen[py::int_(i)], "frozen") ? 1 : 0;
  return told;
}

sim::Vec3 vec3_at(const std::vector<double>& rows, std::size_t i) {
  return {rows[3 * i], rows[3 * i + 1], rows[3 * i + 2]};
}

replay::EngineState state_of(const Told& told, std::size_t i, const sim::Bodies& before) {
  replay::EngineState state;
  state.position = vec3_at(told.position, i);
  state.velocity = vec3_at(told.velocity, i);
  state.frozen = told.frozen[i] != 0;
  const std::optional<sim::BodyIndex> row = before.find(told.ids[i]);
  if (told.orientation) {
    const std::vector<double>& q = *told.orientation;
    state.orientation = {q[4 * i], q[4 * i + 1], q[4 * i + 2], q[4 * i + 3]};
  } else if (row) {
    state.orientation = before.orientation[*row];
  }
  if (told.spin) {
    state.spin = vec3_at(*told.spin, i);
  } else if (row) {
    state.spin = before.spin[*row];
  }
  return state;
}

struct Value {
  std::size_t channel;
  replay::ChannelValue value;
  replay::ChannelKey key;
};

/// A value of the world, or a dictionary by body, or one by pair of bodies.
/// The bodies whose values a step may have: those that it begins with, and those that its inputs removed.
struct StepBodies {
  const sim::Bodies& now;
  const std::vector<sim::BodyId>& removed;
};

/// A pair is of two of them.
void check_pair(const std::vector<sim::BodyId>& pair, const std::string& channel, const StepBodies& bodies) {
  if (pair.size() != 2) raise(bad_input(channel + ": wanted pairs of ids"));
  for (const sim::BodyId id : pair) {
    if (bodies.now.find(id) || std::ranges::find(bodies.removed, id) != bodies.removed.end()) continue;
    raise(
        bad_input(channel + ": found a value of body " + std::to_string(id) + ", wanted the id of a body that exists"));
  }
  if (pair[0] == pair[1]) {
    raise(bad_input(channel + ": found a pair of body " + std::to_string(pair[0]) + " with itself, wanted two bodies"));
  }
}

void add_values(const std::vector<replay::Channel>& channels, const py::handle& name, const py::handle& given,
                const StepBodies& bodies, std::vector<Value>& values) {
  const std::string text = text_of(name, "channels");
  const auto found = std::ranges::find(channels, text, &replay::Channel::name);
  if (found == channels.end()) {
    std::vector<std::string_view> names;
    names.reserve(channels.size());
    for (const replay::Channel& channel : channels) names.emplace_back(channel.name);
    raise(bad_input("channels: " + found_wanted(in_quotes(text), names.empty() ? "none: the log declares no channel"
                                                                               : list_text(names))));
  }
  const auto channel = static_cast<std::size_t>(found - channels.begin());
  if (found->type.scope == replay::ChannelScope::kWorld) {
    values.push_back({channel, channel_value_of(given, *found), {}});
    return;
  }
  if (!py::isinstance<py::dict>(given)) {
    raise(bad_input("channel " + in_quotes(text) + ": wanted a dictionary of values by " + name_of(found->type.scope)));
  }
  for (const auto& [key, value] : py::reinterpret_borrow<py::dict>(given)) {
    replay::ChannelKey owner;
    if (found->type.scope == replay::ChannelScope::kBody) {
      owner.a = whole_of(key, "channel " + in_quotes(text));
    } else {
      const std::vector<sim::BodyId> pair = ids_of(key, "channel " + in_quotes(text));
      check_pair(pair, "channel " + in_quotes(text), bodies);
      owner = {pair[0], pair[1]};
    }
    values.push_back({channel, channel_value_of(value, *found), owner});
  }
}

/// Rows of (a, b, position, normal, depth, impulse).
std::vector<replay::EngineContact> contacts_of(const py::handle& rows) {
  std::vector<replay::EngineContact> contacts;
  for (const py::handle& row : rows) {
    if (!py::isinstance<py::sequence>(row) || py::len(row) != 6) {
      raise(bad_input("contacts: wanted rows of (a, b, position, normal, depth, impulse)"));
    }
    const auto at = py::reinterpret_borrow<py::sequence>(row);
    const py::object other = at[1];
    contacts.push_back({whole_of(at[0], "contacts: a"), other.is_none() ? 0 : whole_of(other, "contacts: b"),
                        vec3_of(at[2], "contacts: position"), vec3_of(at[3], "contacts: normal"),
                        double_of(at[4], "contacts: depth"), double_of(at[5], "contacts: impulse")});
  }
  std::ranges::stable_sort(contacts, {}, [](const auto& contact) { return std::pair(contact.a, contact.b); });
  return contacts;
}

/// Bytes, or a dictionary of bytes by name.
std::vector<replay::EngineSnapshot> given_snapshots(const py::handle& given) {
  const auto bytes_of = [](const py::handle& bytes) {
    if (!py::isinstance<py::bytes>(bytes)) raise(bad_input("snapshot: wanted bytes, or a dictionary of bytes by name"));
    return bytes.cast<std::string>();
  };
  std::vector<replay::EngineSnapshot> snapshots;
  if (!py::isinstance<py::dict>(given)) {
    snapshots.push_back({"", bytes_of(given)});
    return snapshots;
  }
  for (const auto& [name, bytes] : py::reinterpret_borrow<py::dict>(given)) {
    std::string text = text_of(name, "snapshot: name");
    if (text.size() > replay::kColumnNameBytesMax) {
      raise(bad_input("snapshot: found a name of " + std::to_string(text.size()) + " bytes, wanted at most " +
                      std::to_string(replay::kColumnNameBytesMax)));
    }
    snapshots.push_back({std::move(text), bytes_of(bytes)});
  }
  return snapshots;
}

}  // namespace

void EngineRecorder::step(const py::dict& fields) {
  replay::EngineLog& log = open();
  const Busy busy(busy_);  // from here on: reading arrays may let another thread of Python run
  const Told told = told_of(fields, ids_now());
  std::vector<Value> values;
  if (has(fields, "channels")) {
    const py::dict given = fields["channels"];
    for (const auto& [name, value] : given) add_values(channels_, name, value, {log.bodies(), removed_}, values);
  }
  std::vector<replay::EngineContact> contacts;
  if (has(fields, "contacts")) contacts = contacts_of(fields["contacts"]);
  std::vector<std::string> notes;
  if (has(fields, "notes")) {
    if (py::isinstance<py::str>(fields["notes"])) raise(bad_input("notes: found one text, wanted a list of them"));
    for (const py::handle& note : fields["notes"]) notes.push_back(text_of(note, "notes"));
  }
  std::vector<replay::EngineSnapshot> snapshots;
  if (has(fields, "snapshot")) snapshots = given_snapshots(fields["snapshot"]);
  std::vector<std::uint64_t> phases;
  if (has(fields, "phases")) {
    for (const py::handle& word : fields["phases"]) phases.push_back(whole_of(word, "phases"));
  }
  const double dt = double_of(fields["dt"], "dt");

  const Status written = released([&]() -> Status {
    for (std::size_t i = 0; i < told.ids.size(); ++i) {
      if (Status ok = log.set_state(told.ids[i], state_of(told, i, log.bodies())); !ok.ok()) return ok;
    }
    for (const Value& value : values) {
      if (Status ok = log.set_value(value.channel, value.value, value.key); !ok.ok()) return ok;
    }
    for (const replay::EngineContact& contact : contacts) {
      if (Status ok = log.add_contact(contact); !ok.ok()) return ok;
    }
    for (const std::string& note : notes) {
      if (Status ok = log.add_note(note); !ok.ok()) return ok;
    }
    for (const replay::EngineSnapshot& snapshot : snapshots) {
      const auto bytes = std::as_bytes(std::span(snapshot.bytes));
      if (Status ok = log.add_snapshot(bytes, snapshot.name); !ok.ok()) return ok;
    }
    if (!phases.empty()) {
      if (Status ok = log.set_phase_hashes(phases); !ok.ok()) return ok;
    }
    return log.end_step(dt);
  });
  guard(written);
  removed_.clear();
}

void add_engine_recorder(py::module_& module) {
  py::class_<EngineRecorder, std::unique_ptr<EngineRecorder, InOwnProcess>>(module, "EngineRecorder")
      .def(py::init<const std::string&, const py::dict&>())
      .def("input", &EngineRecorder::input)
      .def("step", &EngineRecorder::step)
      .def("ids", &EngineRecorder::ids)
      .def_property_readonly("coming_step", &EngineRecorder::coming_step)
      .def_property_readonly("finished", &EngineRecorder::is_finished)
      .def("finish", [](EngineRecorder& recorder, const std::string& why) { return dict_of(recorder.finish(why)); });
}

}  // namespace tumble::python
