#include "replay/stream/rollback_check.h"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "replay/stream/last_states.h"
#include "replay/stream/stream_step.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

bool same_vector(const sim::Vec3& a, const sim::Vec3& b) {
  return same_bits(a.x(), b.x()) && same_bits(a.y(), b.y()) && same_bits(a.z(), b.z());
}

bool same_numbers(const StreamNumbers& a, const StreamNumbers& b) { return std::ranges::equal(a, b, same_bits); }

struct SameInput {
  bool operator()(const StreamBody& a, const StreamBody& b) const {
    return a.id == b.id && a.is_static == b.is_static && a.asleep == b.asleep && same_numbers(a.numbers, b.numbers) &&
           a.shape == b.shape && same_vector(a.size, b.size) && a.mesh_hash == b.mesh_hash && a.mass == b.mass &&
           a.friction == b.friction && a.restitution == b.restitution;
  }
  bool operator()(const StreamRemove& a, const StreamRemove& b) const { return a.id == b.id; }
  bool operator()(const StreamPush& a, const StreamPush& b) const {
    return a.id == b.id && same_vector(a.impulse, b.impulse);
  }
  bool operator()(const StreamSetVelocity& a, const StreamSetVelocity& b) const {
    return a.id == b.id && same_vector(a.velocity, b.velocity) && same_vector(a.spin, b.spin);
  }
  bool operator()(const StreamSetGravity& a, const StreamSetGravity& b) const {
    return same_vector(a.gravity, b.gravity);
  }
  bool operator()(const StreamNamedInput& a, const StreamNamedInput& b) const {
    return a.body == b.body && a.name == b.name && a.bytes == b.bytes;
  }
  template <class A, class B>
  bool operator()(const A&, const B&) const {
    return false;
  }
};

std::string name_of(const StreamInput& input) {
  static constexpr std::array kKinds = {"body", "remove", "push", "set_velocity", "set_gravity"};
  const auto* named = std::get_if<StreamNamedInput>(&input);
  const std::string kind = named != nullptr ? in_quotes(named->name) : kKinds[input.index()];
  const std::uint64_t id = std::visit(
      [](const auto& one) -> std::uint64_t {
        if constexpr (requires { one.id; }) return one.id;
        if constexpr (requires { one.body; }) return one.body;
        return 0;
      },
      input);
  return id == 0 ? kind : kind + " of body " + std::to_string(id);
}

/// The first input in which two steps differ; none: they were asked to do the same.
std::optional<std::string> input_difference(const StreamStep& a, const StreamStep& b) {
  if (!same_bits(a.dt, b.dt)) return "dt: " + exact_bits(a.dt) + " → " + exact_bits(b.dt);
  for (std::size_t k = 0; k < std::max(a.inputs.size(), b.inputs.size()); ++k) {
    std::string place = "input " + std::to_string(k + 1) + ": ";
    if (k >= a.inputs.size()) return place + "none → " + name_of(b.inputs[k]);
    if (k >= b.inputs.size()) return place + name_of(a.inputs[k]) + " → none";
    if (std::visit(SameInput(), a.inputs[k], b.inputs[k])) continue;
    const std::string before = name_of(a.inputs[k]), after = name_of(b.inputs[k]);
    place += before;
    place += before == after ? " has other values" : " → ";
    if (before != after) place += after;
    return place;
  }
  return std::nullopt;
}

std::string text_of(const RollbackDifference& found) {
  std::string text = found.body ? "body " + std::to_string(*found.body) + ' ' : "";
  text += found.field;
  return found.before.empty() ? text : text + ": " + found.before + " → " + found.after;
}

StreamStates states_of(const StreamStep& step) {
  StreamStates states;
  for (const StreamState& state : step.states) states[state.id] = state;
  return states;
}

std::optional<RollbackDifference> field_difference(std::uint64_t step, const StreamState& a, const StreamState& b) {
  for (std::size_t i = 0; i < kStreamNumberNames.size(); ++i) {
    if (same_bits(a.numbers[i], b.numbers[i])) continue;
    return RollbackDifference{step, a.id, kStreamNumberNames[i], exact_bits(a.numbers[i]), exact_bits(b.numbers[i])};
  }
  if (a.asleep == b.asleep) return std::nullopt;
  return RollbackDifference{step, a.id, "asleep", a.asleep ? "1" : "0", b.asleep ? "1" : "0"};
}

using Found = std::optional<RollbackDifference>;

/// Steps taken again after one rewind, compared with those before it.
class Rewound {
 public:
  explicit Rewound(LastStates& last) : last_(last) {}

  /// The first body whose state differs. A body without a state or a number in a frame is as before that frame, and up
  /// to there both sides are equal.
  Result<Found> state_difference(const StreamFrame& frame, const StreamStep& before, const StreamStep& after) {
    StreamStates a = states_of(before), b = states_of(after);
    for (const auto& [id, state] : a) b.try_emplace(id, StreamState{id, true});
    std::set<std::uint64_t> unknown;
    for (const auto& [id, state] : b) {
      const StreamState& was = a.try_emplace(id, StreamState{id, true}).first->second;
      if (was.same != state.same && !known_.contains(id)) unknown.insert(id);
    }
    if (Status ok = last_.get().find(frame, unknown, known_); !ok.ok()) return ok.error();
    for (const auto& [id, state] : b) {
      Found found = body_difference(frame.step, a.at(id), state, wakes(after, id));
      if (found) return found;
    }
    return Found();
  }

 private:
  Found body_difference(std::uint64_t step, StreamState before, StreamState after, bool woken) {
    if (const auto known = known_.find(after.id); woken && known != known_.end()) known->second.asleep = false;
    if (before.same && after.same) return {};
    for (StreamState* state : {&before, &after}) {
      if (!state->same) continue;
      const auto known = known_.find(state->id);
      if (known == known_.end()) return {};
      *state = known->second;
    }
    known_[after.id] = after;
    return field_difference(step, before, after);
  }

  std::reference_wrapper<LastStates> last_;
  StreamStates known_;  // since the rewind, and before it where one side had none
};

bool same_contacts(const StreamStep& a, const StreamStep& b) {
  return std::ranges::equal(a.contacts, b.contacts, [](const StreamContact& x, const StreamContact& y) {
    return x.a == y.a && x.b == y.b && x.part == y.part && same_vector(x.normal, y.normal) &&
           std::ranges::equal(x.points, y.points, [](const StreamPoint& p, const StreamPoint& q) {
             return same_vector(p.position, q.position) && same_bits(p.depth, q.depth) &&
                    same_bits(p.impulse, q.impulse);
           });
  });
}

/// Of all but states.
Found part_difference(const StreamStep& before, const StreamStep& after) {
  const auto part = [&](const char* name) { return RollbackDifference{before.step, {}, name, "", ""}; };
  if (!same_contacts(before, after)) return part("contacts");
  if (!std::ranges::equal(before.phases, after.phases, [](const StreamPhase& a, const StreamPhase& b) {
        return a.phase == b.phase && a.row == b.row && a.word == b.word;
      })) {
    return part("phase hashes");
  }
  if (!std::ranges::equal(before.values, after.values, [](const StreamValue& a, const StreamValue& b) {
        return a.channel == b.channel && a.a == b.a && a.b == b.b && a.bytes == b.bytes;
      })) {
    return part("channels");
  }
  return before.hashes == after.hashes ? std::nullopt : std::optional(part("hashes"));
}

}  // namespace

namespace {

/// One rewind's steps in turn.
class Check {
 public:
  explicit Check(const StreamReader& stream) : stream_(stream), last_(stream), rewound_(last_) {}

  Status add(const SupersededStep& pair) {
    if (pair.after.step != next_) {  // of another rewind
      behind_.clear();
      rewound_ = Rewound(last_);
    }
    next_ = pair.after.step + 1;
    if (!behind_.empty()) return pass_over(pair, behind_);
    const Result<StreamStep> before = decoded(stream_, pair.before);
    if (!before.ok()) return before.error();
    const Result<StreamStep> after = decoded(stream_, pair.after);
    if (!after.ok()) return after.error();
    const std::string step = "step " + std::to_string(pair.after.step);
    if (const auto other = input_difference(*before, *after)) {
      behind_ = "not compared: " + step + " had other inputs";
      return pass_over(pair, *other);
    }
    ++found_.compared;
    Result<Found> states = rewound_.state_difference(pair.before, *before, *after);
    if (!states.ok()) return states.error();
    Found found = *states ? *std::move(states) : part_difference(*before, *after);
    found_.steps.emplace_back(pair.after.step, Superseded{true, found ? text_of(*found) : ""});
    if (!found) return {};
    behind_ = "not compared: " + step + " came out otherwise";
    ++found_.different;
    if (!found_.first) found_.first = std::move(found);
    return {};
  }

  RollbackCheck take() { return std::move(found_); }

 private:
  Status pass_over(const SupersededStep& pair, const std::string& why) {
    ++found_.not_compared;
    found_.steps.emplace_back(pair.after.step, Superseded{false, why});
    return {};
  }

  const StreamReader& stream_;
  RollbackCheck found_;
  std::uint64_t next_ = 0;  // the step that would go on with the steps taken again after one rewind
  std::string behind_;      // why the steps of this rewind are compared no more; empty: they are
  LastStates last_;
  Rewound rewound_;
};

}  // namespace

Result<RollbackCheck> check_rollbacks(const StreamReader& stream) {
  Check check(stream);
  for (const SupersededStep& pair : stream.superseded()) {
    if (Status ok = check.add(pair); !ok.ok()) return ok.error();
  }
  return check.take();
}

std::string describe(const RollbackCheck& check) {
  std::string text = count_text(check.compared, "step") + " taken again with equal inputs";
  if (check.not_compared > 0) {
    text +=
        " (" + std::to_string(check.not_compared) + " more with or behind other inputs or a difference, not compared)";
  }
  if (!check.first) return text + (check.compared > 0 ? ", all with equal results" : "");
  text += "; step " + std::to_string(check.first->step) + " came out otherwise: " + text_of(*check.first);
  if (check.different > 1) text += "; " + std::to_string(check.different) + " rewinds with a difference";
  return text;
}

}  // namespace tumble::replay
