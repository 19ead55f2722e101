#include "tumble/replay/tolerance.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "replay/diff/parameters.h"
#include "replay/format/little_endian.h"
#include "src/base/text.h"
#include "tumble/replay/field_value.h"

namespace tumble::replay {
namespace {

constexpr std::string_view kChannelPrefix = "channel.";  // of the fields that are channels

/// Calls visit(i, j) with the rows of every body that both states have. A body that one of them lacks makes no
/// difference to the others.
template <class Visit>
void for_each_common_body(const BodyStates& a, const BodyStates& b, Visit visit) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (a.id[i] == b.id[j]) {
      visit(i++, j++);
    } else {
      ++(a.id[i] < b.id[j] ? i : j);
    }
  }
}

double tolerance_of(const Tolerances& tolerances, std::size_t column) {
  if (column >= kPosition) return tolerances.position;
  return column >= kSpin ? tolerances.spin : tolerances.velocity;
}

void forgive_orientation(const sim::Quat& wanted, BodyStates& actual, std::size_t row, double tolerance) {
  const sim::Quat found = actual.orientation[row];
  const auto is_close = [&] {  // a quaternion of another length turns alike but is no equal state
    const double longer = std::sqrt(sim::squared_length(wanted)) - std::sqrt(sim::squared_length(found));
    return tolerance > 0 && angle_between(wanted, found) <= tolerance && std::fabs(longer) <= tolerance;
  };
  if (same_rotation(wanted, found) || is_close()) actual.orientation.set(row, wanted);
}

/// The numbers of an input by name, "throw.velocity.y", in order. Number: double or const double.
template <class Number, class Command>
std::vector<std::pair<std::string, Number*>> numbers_of(Command& command) {
  const std::string kind = sim::name_of(command);
  std::vector<std::pair<std::string, Number*>> numbers;
  for_each_value(command, [&](const std::string& name, auto& value) {
    using Value = std::remove_const_t<std::remove_reference_t<decltype(value)>>;
    if constexpr (std::is_same_v<Value, double>) numbers.emplace_back(kind + '.' + name, &value);
  });
  return numbers;
}

/// "throw.velocity.y" belongs to "throw.velocity"; empty for a name without components.
std::string whole_of(const std::string& field) {
  const std::size_t dot = field.rfind('.');
  const bool component = dot != std::string::npos && dot + 2 == field.size();
  return component ? field.substr(0, dot) : "";
}

template <class Input>
void add_names(std::vector<std::string>& names) {
  const sim::Command command = Input();
  for (const auto& [name, value] : numbers_of<const double>(command)) names.push_back(name);
  if constexpr (std::is_same_v<Input, sim::Push>) names.insert(names.end(), {"push.at.x", "push.at.y", "push.at.z"});
}

/// The fields of inputs and parameters that can have a tolerance.
std::vector<std::string> known_fields() {
  std::vector<std::string> names = {"dt"};
  std::apply([&](auto... input) { (add_names<decltype(input)>(names), ...); },
             std::tuple<sim::Throw, sim::Push, sim::SetVelocity, sim::SetGravity, sim::SetDt>());
  const sim::WorldDef def;
  for_each_parameter(def, [&](const char* name, const auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>) names.emplace_back(name);
  });
  const std::size_t count = names.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::string whole = whole_of(names[i]);
    if (!whole.empty() && std::ranges::find(names, whole) == names.end()) names.push_back(whole);
  }
  return names;
}

Error unknown_field(const std::string& field, const std::vector<std::string>& known) {
  std::vector<std::string_view> candidates = {"position", "orientation", "velocity", "spin"};
  candidates.insert(candidates.end(), known.begin(), known.end());
  const std::string_view near = nearest_word(field, candidates);
  return bad_input("found field " + in_quotes(field) +
                   ", wanted position, orientation, velocity or spin, or a number of an input or a parameter, as in "
                   "throw.velocity.y, dt or world.gravity" +
                   (near.empty() ? "" : "; is " + std::string(near) + " meant?"));
}

/// The words of some phases of each row. A row that is there for other phases alone is none of theirs.
std::vector<std::uint64_t> words_of(const std::vector<std::uint64_t>& words, std::size_t phases,
                                    const std::vector<std::size_t>& places, bool all) {
  std::vector<std::uint64_t> kept;
  for (std::size_t row = 0; row + phases <= words.size(); row += phases) {
    for (const std::size_t place : places) kept.push_back(words[row + place]);
  }
  const auto row_is_empty = [&] {
    return std::ranges::all_of(kept.end() - static_cast<std::ptrdiff_t>(places.size()), kept.end(),
                               [](std::uint64_t word) { return word == 0; });
  };
  while (!all && !kept.empty() && row_is_empty()) kept.resize(kept.size() - places.size());
  return kept;
}

}  // namespace

bool Tolerances::excuses(const std::string& field, double expected, double actual) const {
  // Channels have whatever names an engine gives them: "joint.x" is no part of "joint".
  const std::string whole = field.starts_with(kChannelPrefix) ? field : whole_of(field);
  for (const std::string& name : {field, whole}) {
    const auto known = fields.find(name);
    if (known != fields.end() && std::fabs(actual - expected) <= known->second) return true;
  }
  return false;
}

Status set_tolerance(Tolerances& tolerances, const std::string& field, double value,
                     const std::vector<Channel>& channels) {
  if (!(value >= 0) || std::isinf(value)) {
    return bad_input("tolerance " + field + ": found " + to_string(FieldValue(value)) + ", wanted a number from 0 on");
  }
  if (field == "position") {
    tolerances.position = value;
  } else if (field == "orientation") {
    tolerances.orientation = value;
  } else if (field == "velocity") {
    tolerances.velocity = value;
  } else if (field == "spin") {
    tolerances.spin = value;
  } else {
    std::vector<std::string> known = known_fields();
    if (std::ranges::find(known, field) != known.end()) {
      tolerances.fields[field] = value;
      return {};
    }
    const std::string name = field.starts_with(kChannelPrefix) ? field.substr(kChannelPrefix.size()) : field;
    const auto channel = std::ranges::find(channels, name, &Channel::name);
    for (const Channel& one : channels) known.push_back(one.name);
    if (channel == channels.end()) return unknown_field(field, known);
    if (!is_number(channel->type.kind)) {
      return bad_input("channel " + in_quotes(name) + " holds " + name_of(channel->type.kind) +
                       ", wanted a channel of numbers");
    }
    tolerances.fields[std::string(kChannelPrefix) + name] = value;
  }
  return {};
}

// atan2 of the two parts of conj(a)·b keeps all digits of a small angle, which acos of their product would lose.
double angle_between(const sim::Quat& a, const sim::Quat& b) {
  const double w = a.w * b.w + ((a.x * b.x + a.y * b.y) + a.z * b.z);
  const sim::Vec3 va = {a.x, a.y, a.z}, vb = {b.x, b.y, b.z};
  const sim::Vec3 turn = vb * a.w - va * b.w - sim::cross(va, vb);
  const double sine = sim::length(turn);
  if (sine == 0 && w == 0) return std::nan("");
  return 2 * std::atan2(sine, std::fabs(w));
}

bool same_rotation(const sim::Quat& a, const sim::Quat& b) {
  return a == b || (a.w == -b.w && a.x == -b.x && a.y == -b.y && a.z == -b.z);
}

void forgive_states(const BodyStates& expected, BodyStates& actual, const Tolerances& tolerances) {
  if (tolerances.exact()) return;
  const ConstColumns wanted = columns_of(expected);
  const Columns found = columns_of(actual);
  for_each_common_body(expected, actual, [&](std::size_t i, std::size_t j) {
    for (std::size_t c = 0; c < kOrientation; ++c) {
      const double tolerance = tolerance_of(tolerances, c), a = (*wanted[c])[i];
      double& b = (*found[c])[j];
      if (tolerance > 0 && std::fabs(b - a) <= tolerance) b = a;
    }
    forgive_orientation(expected.orientation[i], actual, j, tolerances.orientation);
  });
}

void forgive_inputs(const StepRecord& expected, StepRecord& actual, const Tolerances& tolerances) {
  if (tolerances.fields.empty()) return;
  for (const char* name : {"dt", "world.dt", "set_dt.dt"}) {
    if (tolerances.excuses(name, expected.dt, actual.dt)) actual.dt = expected.dt;
  }
  if (!std::ranges::equal(expected.inputs, actual.inputs, {}, &sim::Command::index, &sim::Command::index)) return;
  for (std::size_t i = 0; i < expected.inputs.size(); ++i) {
    const auto wanted = numbers_of<const double>(expected.inputs[i]);
    const auto found = numbers_of<double>(actual.inputs[i]);
    for (std::size_t k = 0; k < std::min(wanted.size(), found.size()); ++k) {
      const auto& [name, value] = wanted[k];
      if (name == found[k].first && tolerances.excuses(name, *value, *found[k].second)) *found[k].second = *value;
    }
  }
}

PhaseMatch match_phases(const LogHeader& a, const LogHeader& b) {
  PhaseMatch match;
  match.equal = same_phase_words(a, b);
  const bool one_engine = a.engine && b.engine && a.engine->name == b.engine->name;
  const bool one_meaning = a.phase_rows_max == b.phase_rows_max && a.phase_hash_version == b.phase_hash_version;
  if (!match.equal && !(one_engine && one_meaning)) return match;
  for (std::size_t i = 0; i < a.phases.size(); ++i) {
    const auto there = std::ranges::find(b.phases, a.phases[i]);
    if (there == b.phases.end()) continue;
    match.names.push_back(a.phases[i]);
    match.in_a.push_back(i);
    match.in_b.push_back(static_cast<std::size_t>(there - b.phases.begin()));
  }
  match.in_order = std::ranges::is_sorted(match.in_b);
  match.all = match.names.size() == a.phases.size() && match.names.size() == b.phases.size();
  return match;
}

void match_phase_words(const PhaseMatch& match, const LogHeader& a, const LogHeader& b, StepRecord& in_a,
                       StepRecord& in_b) {
  const bool held = a.hashes.holds(in_a.step) && b.hashes.holds(in_a.step);
  if (match.equal || match.names.empty() || !held) return leave_out_phase_words(a, b, in_a, in_b);
  in_b.counters.contacts = in_a.counters.contacts;
  in_a.phase_words = words_of(in_a.phase_words, a.phases.size(), match.in_a, match.all);
  in_b.phase_words = words_of(in_b.phase_words, b.phases.size(), match.in_b, match.all);
}

bool in_binary32(const LogHeader& a, const LogHeader& b) {
  const auto is_single = [](const LogHeader& log) { return log.engine && log.engine->precision_bits == kBinary32Bits; };
  return is_single(a) && is_single(b);
}

DerivedValues derived_values(const LogHeader& a, const LogHeader& b) {
  return {a.declared.velocity_derived || b.declared.velocity_derived,
          a.declared.spin_derived || b.declared.spin_derived};
}

void forgive_derived(const DerivedValues& derived, const StepRecord& expected, StepRecord& actual) {
  if (!derived.velocity && !derived.spin) return;
  for_each_common_body(expected.states, actual.states, [&](std::size_t i, std::size_t j) {
    if (derived.velocity) actual.states.velocity.set(j, expected.states.velocity[i]);
    if (derived.spin) actual.states.spin.set(j, expected.states.spin[i]);
  });
  actual.counters.kinetic = expected.counters.kinetic;
  actual.counters.inputs = expected.counters.inputs;
  for (std::size_t i = 0; i < std::min(expected.inputs.size(), actual.inputs.size()); ++i) {
    const auto* from = std::get_if<sim::Throw>(&expected.inputs[i]);
    auto* to = std::get_if<sim::Throw>(&actual.inputs[i]);
    if (from == nullptr || to == nullptr || from->box.id != to->box.id) continue;
    if (derived.velocity) to->box.velocity = from->box.velocity;
    if (derived.spin) to->box.spin = from->box.spin;
  }
}

std::uint64_t forgive_zeros(const BodyStates& expected, BodyStates& actual) {
  const ConstColumns wanted = columns_of(expected);
  const Columns found = columns_of(actual);
  std::uint64_t count = 0;
  for_each_common_body(expected, actual, [&](std::size_t i, std::size_t j) {
    for (std::size_t c = 0; c < kColumnCount; ++c) {
      const double a = (*wanted[c])[i];
      double& b = (*found[c])[j];
      if (a != 0 || b != 0 || bits_of(a) == bits_of(b)) continue;
      b = a;
      ++count;
    }
  });
  return count;
}

std::uint64_t forgive_zeros(const StepRecord& expected, StepRecord& actual) {
  for (const auto energy : {&sim::StepCounters::kinetic, &sim::StepCounters::potential, &sim::StepCounters::inputs,
                            &sim::StepCounters::removed}) {
    if (expected.counters.*energy == actual.counters.*energy) actual.counters.*energy = expected.counters.*energy;
  }
  return forgive_zeros(expected.states, actual.states);
}

}  // namespace tumble::replay
