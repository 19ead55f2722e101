#include "replay/stream/stream_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "replay/format/limits.h"
#include "replay/log/told_bodies.h"
#include "replay/stream/stream_names.h"
#include "src/base/text.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

// TumbleRecShape of tumble_recorder.h.
enum TheirShape : std::uint8_t { kBox = 0, kSphere = 1, kCapsule = 2, kCylinder = 3, kHull = 4 };

constexpr std::array<const char*, 6> kShapeNames = {"box", "sphere", "capsule", "cylinder", "hull", "mesh"};

/// Edge lengths of the box around a shape, in the engine's unit and the body's axes.
sim::Vec3 box_around(const StreamBody& body) {
  const double across = 2 * body.size[0];
  switch (body.shape) {
    case kSphere:
      return {across, across, across};
    case kCapsule:
      return {across, across, across + body.size[1]};
    case kCylinder:
      return {across, across, body.size[1]};
    default:
      return body.size;
  }
}

sim::Vec3 vector_at(const StreamNumbers& numbers, std::size_t at) {
  return {numbers[at], numbers[at + 1], numbers[at + 2]};
}

}  // namespace

EngineState StreamBodies::converted(const StreamNumbers& numbers, bool asleep) const {
  return {axes_.length(vector_at(numbers, 0)), axes_.turn({numbers[3], numbers[4], numbers[5], numbers[6]}),
          axes_.length(vector_at(numbers, 7)), axes_.axial(vector_at(numbers, 10)), asleep};
}

void StreamBodies::note_not_finite(const StreamState& state, std::uint64_t step) {
  const auto found = std::ranges::find_if_not(state.numbers, [](double number) { return std::isfinite(number); });
  if (found_not_finite_ || state.same || found == state.numbers.end()) return;
  found_not_finite_ = true;
  const auto field = static_cast<std::size_t>(found - state.numbers.begin());
  note("not finite", "step " + std::to_string(step) + ": body " + std::to_string(state.id) + ": " +
                         kStreamNumberNames[field] + " is " + exact_bits(*found) + "; the body is lost from there on");
}

sim::BoxDef StreamBodies::add(const StreamBody& body) {
  const EngineState state = converted(body.numbers, body.asleep);
  last_[body.id] = state;
  sim::BoxDef box;
  box.id = body.id;
  box.size = axes_.extents(box_around(body));
  if (body.shape > kCylinder && !meshes_.contains(body.mesh_hash)) {
    note("no mesh", "body " + std::to_string(body.id) + ": a " + kShapeNames[body.shape] +
                        " is logged as the box around it, for the stream has no tumble_rec_mesh() of its hash");
  }
  box.mass = body.is_static && (body.mass == 0 || body.mass == INFINITY) ? 1 : body.mass;
  box.is_static = body.is_static;
  box.position = state.position;
  box.orientation = state.orientation;
  box.velocity = state.velocity;
  box.spin = state.spin;
  box.frozen = state.frozen && !body.is_static;
  box.material.friction = body.friction;
  box.material.restitution = body.restitution;
  keep_within(box);
  edges_[body.id] = box.size.maxCoeff();
  call(body.id, kept_name("body " + std::to_string(body.id) + ": the name", body.name));
  return box;
}

void StreamBodies::call(std::uint64_t id, const std::string& name) {
  if (name.empty()) return;
  names_[id] = name;
  const std::uint64_t first = named_.try_emplace(name, id).first->second;
  if (first == id) return;
  note("one name", "bodies " + std::to_string(first) + " and " + std::to_string(id) + " are both called " +
                       in_quotes(name) + "; commands that look for one body want its number");
}

std::string StreamBodies::kept_name(const std::string& what, const std::string& name) {
  std::string kept = name_for_log(name);
  if (kept == name) return kept;
  const std::string found = name.size() > kStreamNameBytesMax
                                ? count_text(name.size(), "byte")
                                : "control characters or bytes that are no text, each a ? now";
  note("a name", what + " is logged as " + in_quotes(kept) + ": " +
                     found_wanted(found, "at most " + std::to_string(kStreamNameBytesMax) + " bytes of text in UTF-8"));
  return kept;
}

void StreamBodies::add(const StreamMesh& mesh) {
  Shape shape;
  shape.kind = mesh.corners.empty() ? Shape::Kind::kHull : Shape::Kind::kMesh;
  for (const sim::Vec3& point : mesh.points) shape.points.push_back(axes_.length(point));
  shape.triangles = mesh.corners;
  if (const Status ok = check_shape(shape); ok.ok()) {
    const StreamMesh& kept = meshes_.try_emplace(mesh.hash, mesh).first->second;
    if (kept.points == mesh.points && kept.corners == mesh.corners) return;
    note("two meshes", "mesh " + std::to_string(mesh.hash) + ": found two surfaces of one hash; the first is kept");
  } else {
    note("mesh", "mesh " + std::to_string(mesh.hash) + ": " + ok.error().message + "; it is left out");
  }
}

std::optional<Shape> StreamBodies::shape_of(const StreamBody& body) const {
  Shape shape;
  if (body.shape == kBox) return std::nullopt;
  if (body.shape >= kHull) {
    const auto mesh = meshes_.find(body.mesh_hash);
    if (mesh == meshes_.end()) return std::nullopt;
    const bool is_hull = body.shape == kHull || mesh->second.corners.empty();
    shape.kind = is_hull ? Shape::Kind::kHull : Shape::Kind::kMesh;
    for (const sim::Vec3& point : mesh->second.points) shape.points.push_back(axes_.length(point));
    if (!is_hull) shape.triangles = mesh->second.corners;
    return check_shape(shape).ok() ? std::optional(shape) : std::nullopt;
  }
  shape.kind = body.shape == kSphere    ? Shape::Kind::kSphere
               : body.shape == kCapsule ? Shape::Kind::kCapsule
                                        : Shape::Kind::kCylinder;
  shape.radius = body.size[0] * axes_.metres;
  if (body.shape != kSphere) {
    shape.half_length = body.size[1] * axes_.metres / 2;
    while (axes_.along(shape.axis).letter != 'z') shape.axis = static_cast<std::uint8_t>((shape.axis + 1) % 3);
  }
  return shape;
}

std::optional<StreamBodies::Description> StreamBodies::describe(const StreamBody& body) const {
  Description found;
  found.info.id = body.id;
  found.info.name = name_for_log(body.name);
  found.shape = shape_of(body);
  if (found.shape) found.info.shape = hash_of(*found.shape);
  if (found.info.name.empty() && !found.shape) return std::nullopt;
  return found;
}

/// A record "same" of a body that was woken is of its last state, but awake.
void StreamBodies::wake(std::uint64_t id) {
  const auto last = last_.find(id);
  if (last != last_.end()) last->second.frozen = false;
}

std::optional<sim::Command> StreamBodies::command(const StreamInput& input) {
  if (const auto* body = std::get_if<StreamBody>(&input)) return sim::Throw{add(*body)};
  if (const auto* removed = std::get_if<StreamRemove>(&input)) {
    last_.erase(removed->id);
    odd_turns_.erase(removed->id);
    return sim::Remove{removed->id};
  }
  if (const auto* push = std::get_if<StreamPush>(&input)) {
    wake(push->id);
    const Range impulse = {"an impulse of a push", " N s", "push", -sim::kMassMax, sim::kMassMax, 0};
    return sim::Push{push->id, within(push->id, impulse, axes_.length(push->impulse))};
  }
  if (const auto* set = std::get_if<StreamSetVelocity>(&input)) {
    wake(set->id);
    const Range velocity = {"a velocity that was set", " m/s", "set_velocity", -sim::kSpeedMax, sim::kSpeedMax, 0};
    const Range spin = {"an angular velocity that was set", " rad/s", "set_spin", -sim::kSpeedMax, sim::kSpeedMax, 0};
    return sim::SetVelocity{set->id, within(set->id, velocity, axes_.length(set->velocity)),
                            within(set->id, spin, axes_.axial(set->spin))};
  }
  if (const auto* set = std::get_if<StreamSetGravity>(&input)) return sim::SetGravity{gravity(set->gravity)};
  return std::nullopt;
}

Result<EngineState> StreamBodies::state(const StreamState& state, std::uint64_t step) {
  const auto last = last_.find(state.id);
  if (last == last_.end()) {
    return bad_input("found a state of body " + std::to_string(state.id) + ", wanted the id of a body that exists");
  }
  if (state.same) return last->second;
  last->second = converted(state.numbers, state.asleep);
  odd_turns_.erase(state.id);
  sim::Quat& turn = last->second.orientation;
  if (!check_rotation(state.id, turn, EngineState::kLengthOffMax).ok()) {
    odd_turns_[state.id] = turn;
    turn = kept_turn(turn, "step " + std::to_string(step) + ": body " + std::to_string(state.id) + ": an orientation ",
                     "state.orientation");
  }
  return last->second;
}

}  // namespace tumble::replay
