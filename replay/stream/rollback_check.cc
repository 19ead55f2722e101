#include "replay/stream/rollback_check.h"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <map>
#include <utility>
#include <variant>
#include <vector>

#include "replay/stream/stream_step.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::array kNumberNames = {"position.x",    "position.y",    "position.z", "orientation.w", "orientation.x",
                                     "orientation.y", "orientation.z", "velocity.x", "velocity.y",    "velocity.z",
                                     "spin.x",        "spin.y",        "spin.z"};

using States = std::map<std::uint64_t, StreamState>;

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

bool same_inputs(const StreamStep& a, const StreamStep& b) {
  return same_bits(a.dt, b.dt) && std::ranges::equal(a.inputs, b.inputs, [](const auto& x, const auto& y) {
           return std::visit(SameInput(), x, y);
         });
}

States states_of(const StreamStep& step) {
  States states;
  for (const StreamState& state : step.states) states[state.id] = state;
  return states;
}

Result<StreamStep> decoded(const StreamReader& stream, const StreamFrame& frame) {
  const Result<std::vector<std::byte>> payload = stream.read(frame);
  if (!payload.ok()) return payload.error();
  return decode_stream_step(frame.kind, *payload, stream.name() + ": byte " + std::to_string(frame.offset));
}

/// The last state of a body before a frame that a rewind took back. None where a later rewind replaced the steps that
/// would tell.
Result<std::optional<StreamState>> state_before(const StreamReader& stream, const StreamFrame& frame,
                                                std::uint64_t id) {
  const std::vector<StreamFrame>& steps = stream.steps();
  for (std::size_t at = steps.size(); at-- > 0;) {
    if (steps[at].step >= frame.step) continue;
    if (steps[at].offset > frame.offset) break;
    const Result<StreamStep> step = decoded(stream, steps[at]);
    if (!step.ok()) return step.error();
    for (const StreamState& state : step->states) {
      if (state.id == id && !state.same) return std::optional(state);
    }
    for (const StreamInput& input : step->inputs) {
      const auto* body = std::get_if<StreamBody>(&input);
      if (body != nullptr && body->id == id) return std::optional(StreamState{id, false, body->asleep, body->numbers});
    }
  }
  return std::optional<StreamState>();
}

std::optional<RollbackDifference> field_difference(std::uint64_t step, const StreamState& a, const StreamState& b) {
  for (std::size_t i = 0; i < kNumberNames.size(); ++i) {
    if (same_bits(a.numbers[i], b.numbers[i])) continue;
    return RollbackDifference{step, a.id, kNumberNames[i], exact_bits(a.numbers[i]), exact_bits(b.numbers[i])};
  }
  if (a.asleep == b.asleep) return std::nullopt;
  return RollbackDifference{step, a.id, "asleep", a.asleep ? "1" : "0", b.asleep ? "1" : "0"};
}

using Found = std::optional<RollbackDifference>;

/// Steps taken again after one rewind, compared with those before it.
class Rewound {
 public:
  explicit Rewound(const StreamReader& stream) : stream_(stream) {}

  /// The first body whose state differs. A body without a number in a frame is as before that frame, and up to there
  /// both sides are equal.
  Result<Found> state_difference(const StreamFrame& frame, const StreamStep& before, const StreamStep& after) {
    const States a = states_of(before), b = states_of(after);
    for (const auto& [id, state] : a) {
      const auto other = b.find(id);
      if (other == b.end()) return Found({before.step, id, "bodies", "recorded", "not recorded"});
      Result<Found> found = body_difference(frame, state, other->second);
      if (!found.ok() || *found) return found;
    }
    for (const auto& [id, state] : b) {
      if (!a.contains(id)) return Found({before.step, id, "bodies", "not recorded", "recorded"});
    }
    return Found();
  }

 private:
  Result<Found> body_difference(const StreamFrame& frame, StreamState before, StreamState after) {
    if (before.same && after.same) return Found();
    for (StreamState* state : {&before, &after}) {
      if (!state->same) continue;
      const auto known = known_.find(state->id);
      if (known != known_.end()) {
        *state = known->second;
        continue;
      }
      const Result<std::optional<StreamState>> earlier = state_before(stream_, frame, state->id);
      if (!earlier.ok()) return earlier.error();
      if (!*earlier) return Found();
      *state = **earlier;
    }
    known_[after.id] = after;
    return field_difference(frame.step, before, after);
  }

  std::reference_wrapper<const StreamReader> stream_;
  States known_;  // since the rewind
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

Result<RollbackCheck> check_rollbacks(const StreamReader& stream) {
  RollbackCheck check;
  std::uint64_t next = 0;      // the step that would go on with the steps taken again after one rewind
  bool is_comparable = false;  // nothing differed yet since the rewind
  Rewound rewound(stream);
  for (const SupersededStep& pair : stream.superseded()) {
    if (pair.after.step != next) {
      is_comparable = true;
      rewound = Rewound(stream);
    }
    next = pair.after.step + 1;
    if (!is_comparable) {
      ++check.not_compared;
      continue;
    }
    const Result<StreamStep> before = decoded(stream, pair.before);
    if (!before.ok()) return before.error();
    const Result<StreamStep> after = decoded(stream, pair.after);
    if (!after.ok()) return after.error();
    if (!same_inputs(*before, *after)) {
      is_comparable = false;
      ++check.not_compared;
      continue;
    }
    ++check.compared;
    Result<Found> states = rewound.state_difference(pair.before, *before, *after);
    if (!states.ok()) return states.error();
    Found found = *states ? *std::move(states) : part_difference(*before, *after);
    if (!found) continue;
    is_comparable = false;
    ++check.different;
    if (!check.first) check.first = std::move(found);
  }
  return check;
}

std::string describe(const RollbackCheck& check) {
  std::string text = count_text(check.compared, "step") + " taken again with equal inputs";
  if (check.not_compared > 0) {
    text +=
        " (" + std::to_string(check.not_compared) + " more with or behind other inputs or a difference, not compared)";
  }
  if (!check.first) return text + (check.compared > 0 ? ", all with equal results" : "");
  const RollbackDifference& first = *check.first;
  text += "; step " + std::to_string(first.step) + " came out otherwise: ";
  if (first.body) text += "body " + std::to_string(*first.body) + ' ';
  text += first.field;
  if (!first.before.empty()) text += ": " + first.before + " → " + first.after;
  if (check.different > 1) text += "; " + std::to_string(check.different) + " rewinds with a difference";
  return text;
}

}  // namespace tumble::replay
