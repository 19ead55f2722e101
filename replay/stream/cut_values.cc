// The values of a stream that no log can hold, and what becomes of them.
#include <algorithm>
#include <array>
#include <cmath>

#include "replay/format/limits.h"
#include "replay/stream/stream_bodies.h"
#include "src/base/text.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

// TumbleRecShape of tumble_recorder.h.
constexpr std::uint8_t kSphereShape = 1, kCapsuleShape = 2, kCylinderShape = 3;

constexpr std::size_t kTimesMax = 64;   // that one body is told one thing in a step; further values replace the last
constexpr std::size_t kNotesShown = 3;  // of a kind; the others are counted
constexpr std::array<const char*, 3> kComponents = {".x", ".y", ".z"};
const char* component_of(int k) { return kComponents[static_cast<std::size_t>(k)]; }

bool is_round_shape(std::uint8_t shape) { return shape >= kSphereShape && shape <= kCylinderShape; }

}  // namespace

void StreamBodies::note(const char* kind, std::string text) {
  auto known = std::ranges::find(notes_, kind, &Notes::kind);
  if (known == notes_.end()) known = notes_.insert(known, Notes{kind, {}, 0});
  if (std::ranges::find(known->texts, text) != known->texts.end()) return;
  ++known->count;
  if (known->texts.size() < kNotesShown) known->texts.push_back(std::move(text));
}

std::vector<std::string> StreamBodies::notes() const {
  std::vector<std::string> all;
  for (const Notes& one : notes_) {
    all.insert(all.end(), one.texts.begin(), one.texts.end());
    if (one.count > one.texts.size()) {
      all.back() += ", and " + count_text(one.count - one.texts.size(), "more value") + " of this kind";
    }
  }
  plausible_.add_to(all, [this](sim::BodyId id) {
    const auto named = names_.find(id);
    return named == names_.end() ? std::string() : named->second;
  });
  return all;
}

void StreamBodies::tell(std::uint64_t id, const std::string& name, double value) {
  const std::string first = std::string(kToldPrefix) + name;
  std::string channel = first;
  for (std::size_t n = 2; n <= kTimesMax && told_.contains({channel, id}); ++n)
    channel = first + '#' + std::to_string(n);
  told_[{channel, id}] = value;
}

void StreamBodies::note_cut(std::uint64_t id, const Range& range, const char* component, double value, double cut) {
  const std::string owner = id == 0 ? "" : "body " + std::to_string(id) + ": ";
  const std::string name = std::string(range.name) + component;
  tell(id, name, value);
  note(range.what, owner + range.what + " of " + number_text(value) + range.unit + " is logged as " + number_text(cut) +
                       range.unit + "; channel " + std::string(kToldPrefix) + name + " keeps what was told");
}

double StreamBodies::within(std::uint64_t id, const Range& range, double value, const char* component) {
  if (value >= range.low && value <= range.high) return value;
  const double cut = std::isnan(value) ? range.for_nan : std::clamp(value, range.low, range.high);
  note_cut(id, range, component, value, cut);
  return cut;
}

sim::Vec3 StreamBodies::within(std::uint64_t id, const Range& range, const sim::Vec3& value) {
  return {within(id, range, value.x(), kComponents[0]), within(id, range, value.y(), kComponents[1]),
          within(id, range, value.z(), kComponents[2])};
}

sim::Vec3 StreamBodies::gravity(const sim::Vec3& theirs) {
  const Range range = {"a gravity", " m/s²", "gravity", -sim::kGravityMax, sim::kGravityMax, 0};
  sim::Vec3 kept = within(0, range, axes_.length(theirs));
  plausible_.set_gravity(kept);
  return kept;
}

double StreamBodies::length_within(std::uint64_t id, const Range& range, double theirs, const char* component) {
  const double metres = theirs * axes_.metres;
  if ((theirs > 0 || metres == range.low) && metres <= range.high) return theirs;
  if (theirs < 0 && -metres <= range.high) {
    note_cut(id, range, component, metres, -metres);
    return -theirs;
  }
  return within(id, range, metres, component) / axes_.metres;
}

void StreamBodies::keep_sizes(StreamStep& step) {
  const double most = kShapeLengthMax / 2;  // far enough below for a unit that rounds
  const Range radius = {"a radius", " m", "radius", sim::kSizeMin, most, 1};
  for (StreamInput& input : step.inputs) {
    auto* body = std::get_if<StreamBody>(&input);
    if (body == nullptr) continue;
    const bool is_round = is_round_shape(body->shape);
    if (is_round) body->size[0] = length_within(body->id, radius, body->size[0]);
    if (is_round && body->shape != kSphereShape) {
      const Range length = {"a length", " m", "length", body->shape == kCapsuleShape ? 0 : sim::kSizeMin, most, 1};
      body->size[1] = length_within(body->id, length, body->size[1]);
    }
    for (int k = 0; k < 3 && !is_round; ++k) {  // what else is wrong with an edge, keep_within() sees
      if (!(body->size[k] < 0)) continue;
      sim::Vec3 along = {0, 0, 0};
      along[k] = 1;
      int ours = 0;
      (void)axes_.extents(along).maxCoeff(&ours);
      body->size[k] = length_within(body->id, {"an edge", " m", "size", 0, most, 1}, body->size[k], component_of(ours));
    }
  }
}

void StreamBodies::keep_within(sim::BoxDef& box) {
  const Range edge = {"an edge", " m", "size", sim::kSizeMin, sim::kSizeMax, 1};
  for (int k = 0; k < 3; ++k) {
    // A shape that was cut itself, or cut already as a negative edge, has told its own value.
    const bool is_told = told_.contains({std::string(kToldPrefix) + "size" + component_of(k), box.id}) ||
                         told_.contains({std::string(kToldPrefix) + "radius", box.id}) ||
                         told_.contains({std::string(kToldPrefix) + "length", box.id});
    if (is_told) {
      box.size[k] = std::clamp(box.size[k], edge.low, edge.high);
    } else {
      box.size[k] = within(box.id, edge, box.size[k], component_of(k));
    }
  }
  sim::Material& material = box.material;
  box.mass = within(box.id, {"a mass", " kg", "mass", sim::kMassMin, sim::kMassMax, 1}, box.mass);
  material.friction = within(box.id, {"a friction", "", "friction", 0, sim::kFrictionMax, 0}, material.friction);
  material.friction_dynamic = material.friction;
  material.restitution = within(box.id, {"a restitution", "", "restitution", 0, 1, 0}, material.restitution);
  keep_motion_within(box);
  keep_rotation(box);
}

/// The motion that no scene can hold is that of state 0 all the same: states are kept to the bit.
void StreamBodies::keep_motion_within(sim::BoxDef& box) {
  const Range place = {"a coordinate at its start", " m", "position", -sim::kPositionMax, sim::kPositionMax, 0};
  const Range velocity = {"a velocity at its start", " m/s", "velocity", -sim::kSpeedMax, sim::kSpeedMax, 0};
  const Range spin = {"an angular velocity at its start", " rad/s", "spin", -sim::kSpeedMax, sim::kSpeedMax, 0};
  if (!in_start_) {
    const std::size_t told = told_.size();
    box.position = within(box.id, place, box.position);
    box.velocity = within(box.id, velocity, box.velocity);
    box.spin = within(box.id, spin, box.spin);
    if (told_.size() > told) thrown_beyond_.insert(box.id);
    return;
  }
  bool is_cut = false;
  const auto cut = [&](const Range& range, double value) {
    const double kept = std::isnan(value) ? range.for_nan : std::clamp(value, range.low, range.high);
    if (kept == value) return value;
    is_cut = true;
    note(range.what, "body " + std::to_string(box.id) + ": " + range.what + " of " + number_text(value) + range.unit +
                         " is beyond what a scene holds: the state of step 0 keeps it, the scene has " +
                         number_text(kept) + range.unit);
    return kept;
  };
  for (int k = 0; k < 3; ++k) {
    box.position[k] = cut(place, box.position[k]);
    box.velocity[k] = cut(velocity, box.velocity[k]);
    box.spin[k] = cut(spin, box.spin[k]);
  }
  const sim::Quat& q = box.orientation;
  if (is_cut || !std::isfinite(q.w + q.x + q.y + q.z)) start_states_.emplace_back(box.id, last_[box.id]);
}

sim::Quat StreamBodies::kept_turn(const sim::Quat& q, const std::string& what, const char* channels) {
  const double length = std::sqrt(sim::squared_length(q));
  const bool has_length = length > 1e-6 && length < 1e6;
  note("no rotation", what +
                          (has_length ? "of length " + significant(length, 9) + " is logged divided by its length"
                                      : "that is no rotation is logged as none") +
                          "; channels " + std::string(kToldPrefix) + channels + " keep what was told");
  return has_length ? sim::Quat{q.w / length, q.x / length, q.y / length, q.z / length} : sim::Quat();
}

void StreamBodies::tell_turn(std::uint64_t id, const std::string& name, const sim::Quat& q) {
  tell(id, name + ".w", q.w);
  tell(id, name + ".x", q.x);
  tell(id, name + ".y", q.y);
  tell(id, name + ".z", q.z);
}

void StreamBodies::add_untold(StreamStep& step) {
  for (const StreamState& told : step.states) thrown_beyond_.erase(told.id);
  for (const std::uint64_t id : std::exchange(thrown_beyond_, {})) {
    if (last_.contains(id)) step.states.push_back({id, true});
  }
}

void StreamBodies::tell_turns() {
  for (const auto& [id, turn] : odd_turns_) tell_turn(id, "state.orientation", turn);
}

void StreamBodies::keep_rotation(sim::BoxDef& box) {
  const sim::Quat q = box.orientation;
  odd_turns_.erase(box.id);
  if (std::fabs(std::sqrt(sim::squared_length(q)) - 1) <= EngineState::kLengthOffMax) return;
  const std::string named = "body " + std::to_string(box.id) + ": an orientation at its start ";
  const bool is_finite = std::isfinite(q.w + q.x + q.y + q.z);
  if (!is_finite && in_start_) {
    box.orientation = sim::Quat();
    note("no rotation", named + "that is no rotation is logged as none; the state of step 0 keeps what was told");
    return;
  }
  box.orientation = kept_turn(q, named, "orientation");
  tell_turn(box.id, "orientation", q);
  if (!is_finite) {
    thrown_beyond_.insert(box.id);
    return;
  }
  odd_turns_[box.id] = q;
  last_[box.id].orientation = box.orientation;  // for records of kind "same"
  for (auto& [id, state] : start_states_) {
    if (id == box.id) state.orientation = box.orientation;
  }
}

std::vector<std::pair<sim::BodyId, EngineState>> StreamBodies::end_start() {
  in_start_ = false;
  return std::exchange(start_states_, {});
}

ToldValues StreamBodies::cut(StreamStep& step) {
  keep_sizes(step);
  for (const StreamInput& input : step.inputs) (void)command(input);
  for (const StreamState& told : step.states) (void)state(told, step.step);
  if (!in_start_) tell_turns();
  return take_told();
}

}  // namespace tumble::replay
