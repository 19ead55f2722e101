#include "tumble/replay/divergence.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "replay/diff/input_difference.h"
#include "replay/format/little_endian.h"
#include "src/base/check.h"
#include "src/base/text.h"
#include "tumble/replay/body_states.h"
#include "tumble/replay/tolerance.h"

namespace tumble::replay {
namespace {

constexpr const char* kNoNumberWords = "not a number";
constexpr const char* kInfiniteWords = "infinite";
constexpr const char* kBodyField = "body";  // of a difference: one of the two has no such body

/// Causes before effects: a step with another dt or other inputs differs in everything after, so these come first.
std::optional<Divergence> different_start(const StepRecord& expected, const StepRecord& actual) {
  if (bits_of(expected.dt) != bits_of(actual.dt)) {
    return make_divergence(expected.step, "inputs", "dt", expected.dt, actual.dt);
  }
  std::optional<InputDifference> inputs = first_difference(expected.inputs, actual.inputs);
  if (!inputs) return std::nullopt;
  Divergence found = make_divergence(expected.step, "inputs", inputs->field, inputs->expected, inputs->actual);
  found.body = inputs->body;
  return found;
}

std::string hex(std::uint64_t word) { return to_string(Hash128{0, word}).substr(16); }

/// The first substep and phase that wrote another value.
std::optional<Divergence> different_phase(const StepRecord& expected, const StepRecord& actual,
                                          const std::vector<std::string>& phases) {
  if (phases.empty() || expected.phase_words == actual.phase_words) return std::nullopt;
  const std::size_t shorter = std::min(expected.phase_words.size(), actual.phase_words.size());
  const auto word = static_cast<std::size_t>(
      std::mismatch(expected.phase_words.begin(), expected.phase_words.begin() + static_cast<std::ptrdiff_t>(shorter),
                    actual.phase_words.begin())
          .first -
      expected.phase_words.begin());
  const auto text = [word](const StepRecord& record) {
    return word < record.phase_words.size() ? hex(record.phase_words[word]) : std::string("no such substep");
  };
  Divergence divergence =
      make_divergence(expected.step, phases[word % phases.size()], "phase_hash", text(expected), text(actual));
  divergence.substep = static_cast<std::uint32_t>(word / phases.size());
  return divergence;
}

/// Counters come last: they differ alone only where states agree in every bit.
std::optional<Divergence> different_counter(const StepRecord& expected, const StepRecord& actual) {
  const auto count = [&](const char* field, std::uint32_t sim::StepCounters::*counter) -> std::optional<Divergence> {
    const std::uint64_t a = expected.counters.*counter;
    const std::uint64_t b = actual.counters.*counter;
    if (a == b) return std::nullopt;
    return make_divergence(expected.step, "step", field, a, b);
  };
  const auto energy = [&](const char* field, double sim::StepCounters::*counter) -> std::optional<Divergence> {
    const double a = expected.counters.*counter;
    const double b = actual.counters.*counter;
    if (bits_of(a) == bits_of(b)) return std::nullopt;
    return make_divergence(expected.step, "step", field, a, b);
  };
  if (auto d = energy("input_energy", &sim::StepCounters::inputs)) return d;
  if (auto d = count("substeps", &sim::StepCounters::substeps)) return d;
  if (auto d = count("pairs", &sim::StepCounters::pairs)) return d;
  if (auto d = count("contacts", &sim::StepCounters::contacts)) return d;
  if (auto d = energy("kinetic", &sim::StepCounters::kinetic)) return d;
  if (auto d = energy("potential", &sim::StepCounters::potential)) return d;
  return energy("removed_energy", &sim::StepCounters::removed);
}

/// What the two values hide from a reader: other signs of one rotation, the angle of two, zeros.
std::string note_of(const BodyStates& expected, const BodyStates& actual, std::size_t i, std::size_t column) {
  if (column >= kOrientation) {
    const sim::Quat a = expected.orientation[i], b = actual.orientation[i];
    if (same_rotation(a, b)) return a == b ? "zeros of other sign" : "same rotation, other sign";
    const double angle = angle_between(a, b);
    if (angle == 0) return "same rotation, quaternion of other length";
    return std::isfinite(angle) ? "the rotations are " + rounded(angle, "rad") + " apart" : "no rotation";
  }
  const double a = (*columns_of(expected)[column])[i], b = (*columns_of(actual)[column])[i];
  return a == b ? "zeros of other sign" : "";
}

const char* unit_of(const std::string& field) {
  if (field.starts_with("contact.position.") || field == "contact.depth") return "m";
  if (field == "contact.impulse") return "N s";
  if (field.starts_with("position.")) return "m";
  if (field.starts_with("velocity.")) return "m/s";
  return field.starts_with("spin.") ? "rad/s" : "";
}

std::optional<Divergence> different_body(const BodyStates& expected, const BodyStates& actual, std::size_t i) {
  const ConstColumns a = columns_of(expected);
  const ConstColumns b = columns_of(actual);
  std::optional<Divergence> found;
  for (const std::size_t c : kFieldOrder) {
    const double value_a = (*a[c])[i];
    const double value_b = (*b[c])[i];
    if (bits_of(value_a) == bits_of(value_b)) continue;
    found = make_divergence(0, "step", kColumnNames[c], value_a, value_b);
    found->note = note_of(expected, actual, i, c);
    break;
  }
  if (!found && expected.frozen[i] != actual.frozen[i]) {
    found = make_divergence(0, "step", "frozen", std::uint64_t{expected.frozen[i]}, std::uint64_t{actual.frozen[i]});
  }
  if (found) found->body = expected.id[i];
  return found;
}

}  // namespace

Divergence make_divergence(std::uint64_t step, std::string phase, std::string field, FieldValue expected,
                           FieldValue actual) {
  Divergence divergence;
  divergence.step = step;
  divergence.phase = std::move(phase);
  divergence.field = std::move(field);
  divergence.expected = std::move(expected);
  divergence.actual = std::move(actual);
  const auto* a = std::get_if<double>(&divergence.expected);
  const auto* b = std::get_if<double>(&divergence.actual);
  if (a != nullptr && b != nullptr) divergence.ulps = ulps_between(*a, *b);
  return divergence;
}

std::optional<Divergence> different_ids(const std::vector<sim::BodyId>& expected,
                                        const std::vector<sim::BodyId>& actual) {
  const auto [in_a, in_b] = std::ranges::mismatch(expected, actual);
  if (in_a == expected.end() && in_b == actual.end()) return std::nullopt;
  const bool only_expected = in_b == actual.end() || (in_a != expected.end() && *in_a < *in_b);
  const sim::BodyId body = only_expected ? *in_a : *in_b;
  Divergence divergence;
  divergence.phase = "step";
  divergence.field = kBodyField;
  divergence.body = body;
  divergence.expected = std::monostate();
  divergence.actual = std::monostate();
  (only_expected ? divergence.expected : divergence.actual) = std::uint64_t{body};
  return divergence;
}

void count_in_binary32(Divergence& divergence) {
  if (divergence.field.starts_with("channel.")) return;  // which has its own kind
  const auto* a = std::get_if<double>(&divergence.expected);
  const auto* b = std::get_if<double>(&divergence.actual);
  if (a != nullptr && b != nullptr) divergence.ulps = ulps32_between(*a, *b);
}

bool is_in_state(const Divergence& divergence) {
  if (!divergence.body) return false;
  return divergence.field == "frozen" || divergence.field == kBodyField ||
         std::ranges::find(kColumnNames, divergence.field) != kColumnNames.end();
}

bool is_body_missing(const Divergence& divergence) { return divergence.body && divergence.field == kBodyField; }

std::string only_in(const Divergence& missing_body, const std::string& expected, const std::string& actual) {
  SIM_CHECK(is_body_missing(missing_body), missing_body.step);
  return "only in " + (std::holds_alternative<std::monostate>(missing_body.actual) ? expected : actual);
}

std::string magnitude(const Divergence& divergence) {
  const auto* a = std::get_if<double>(&divergence.expected);
  const auto* b = std::get_if<double>(&divergence.actual);
  const bool of_extra = divergence.field.starts_with("contact.") || divergence.field.starts_with("channel.");
  if (a == nullptr || b == nullptr || !(is_in_state(divergence) || of_extra)) return "";
  const double apart = std::fabs(*a - *b);
  if (!std::isfinite(apart)) return std::isnan(*a) || std::isnan(*b) ? kNoNumberWords : kInfiniteWords;
  return rounded(apart, unit_of(divergence.field));
}

std::string apart_words(const Divergence& divergence) {
  const std::string size = magnitude(divergence);
  if (size == kNoNumberWords) return ", one is not a number";
  return size.empty() ? "" : ", " + (size == kInfiniteWords ? "infinitely far" : size) + " apart";
}

std::string describe(const Divergence& d) {
  std::string text = "step " + std::to_string(d.step);
  if (d.substep) text += ", substep " + std::to_string(*d.substep);
  text += ", phase " + d.phase;
  if (d.body) text += ", body " + std::to_string(*d.body);
  if (d.pair) {
    text += ", pair " + std::to_string(d.pair->first) + " and " +
            (d.pair->second == 0 ? "the ground" : std::to_string(d.pair->second));
  }
  if (!d.names.empty()) text += " (" + d.names + ")";
  if (is_body_missing(d)) {
    return text + (std::holds_alternative<std::monostate>(d.actual) ? ": expected, but not there"
                                                                    : ": there, but not expected");
  }
  text += ", " + d.field + ": expected " + to_string(d.expected) + ", actual " + to_string(d.actual);
  if (d.ulps) text += " (" + std::to_string(*d.ulps) + (*d.ulps == 1 ? " ulp)" : " ulps)");
  if (!d.note.empty()) text += "; " + d.note;
  return text;
}

std::optional<Divergence> first_difference(const BodyStates& expected, const BodyStates& actual) {
  std::optional<Divergence> ids = different_ids(expected.id, actual.id);
  const std::size_t shorter = std::min(expected.size(), actual.size());
  for (std::size_t i = 0; i < shorter && expected.id[i] == actual.id[i]; ++i) {
    if (auto found = different_body(expected, actual, i)) return found;
  }
  return ids;
}

bool same_columns(const ConstColumns& a, std::size_t i, const ConstColumns& b, std::size_t j) {
  for (std::size_t c = 0; c < kColumnCount; ++c) {
    if (bits_of((*a[c])[i]) != bits_of((*b[c])[j])) return false;
  }
  return true;
}

std::vector<sim::BodyId> differing_bodies(const BodyStates& a, const BodyStates& b) {
  std::vector<sim::BodyId> ids;
  const ConstColumns in_a = columns_of(a), in_b = columns_of(b);
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (a.id[i] != b.id[j]) {
      ++(a.id[i] < b.id[j] ? i : j);
      continue;
    }
    if (a.frozen[i] != b.frozen[j] || !same_columns(in_a, i, in_b, j)) ids.push_back(a.id[i]);
    ++i;
    ++j;
  }
  return ids;
}

// The order follows time: what led into the step, its phases, its result. Phase words find the first phase that wrote
// another value but cannot say where; states say body and field but not when. Where both are there, the answer has the
// phase of the one and the body of the other.
std::optional<Divergence> first_difference(const StepRecord& expected, const StepRecord& actual,
                                           const std::vector<std::string>& phases) {
  if (auto found = different_start(expected, actual)) return found;
  std::optional<Divergence> found = different_phase(expected, actual, phases);
  const bool have_states = expected.has_states && actual.has_states;
  if (!found && expected.state_hash != actual.state_hash) {
    found = make_divergence(expected.step, "step", "state_hash", to_string(expected.state_hash),
                            to_string(actual.state_hash));
  }
  if (have_states && (found || !same_bits(expected.states, actual.states))) {
    if (auto body = first_difference(expected.states, actual.states)) {
      body->step = expected.step;
      if (found) {
        body->phase = found->phase;
        body->substep = found->substep;
      }
      return body;
    }
  }
  return found ? found : different_counter(expected, actual);
}

}  // namespace tumble::replay
