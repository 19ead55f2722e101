#include "replay/picture/picture_source.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "replay/picture/picture_markers.h"
#include "src/base/check.h"
#include "src/render/scene/solid.h"

namespace tumble::replay {
namespace {

using render::BoxLook;
using render::Colour;
using render::Snapshot;

constexpr Colour kOurs = {1.0F, 0.36F, 0.02F};
constexpr Colour kTheirs = {0.05F, 0.30F, 1.0F};

BoxLook look_of(const BodyStates& states, std::size_t row, const sim::BoxDef& box, const PictureOptions& options) {
  BoxLook look;
  look.id = states.id[row];
  look.centre = states.position[row];
  look.orientation = states.orientation[row];
  look.half_extent = box.size / 2;
  look.velocity = states.velocity[row];
  look.spin = states.spin[row];
  look.texture = box.material.texture;
  if (options.freezing && states.frozen[row] == 0 && !box.is_static) look.texture = sim::Texture::kWhite;
  return look;
}

bool same_pose(const BoxLook& a, const BoxLook& b) {
  const bool same_shape = (a.solid == nullptr) == (b.solid == nullptr) && a.half_extent == b.half_extent;
  return same_shape && a.centre == b.centre && a.orientation == b.orientation;
}

render::Solid solid_from(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::kSphere:
      return render::make_capsule(2, shape.radius, 0);
    case Shape::Kind::kCapsule:
      return render::make_capsule(shape.axis, shape.radius, shape.half_length);
    case Shape::Kind::kCylinder:
      return render::make_cylinder(shape.axis, shape.radius, shape.half_length);
    case Shape::Kind::kHull:
      return render::make_hull(shape.points);
    case Shape::Kind::kMesh:
      return render::make_mesh(shape.points, shape.triangles);
  }
  return {};
}

BoxLook coloured(BoxLook look, const Colour& colour) {
  look.texture = sim::Texture::kConcrete;
  look.tint = colour;
  return look;
}

}  // namespace

PictureSource::PictureSource(LogReader& log) : log_(&log), states_(log), scanned_(log.first_state()) {
  for (const sim::BoxDef& box : log.header().scene.boxes) boxes_.emplace(box.id, box);
  infos_.add(log.header().declared.bodies, log.header().declared.shapes);
}

/// Null: the body is a box, or no triangle is known of its surface.
std::shared_ptr<const render::Solid> PictureSource::solid_of(sim::BodyId id) {
  const Shape* shape = infos_.shape(id);
  if (shape == nullptr) return nullptr;
  const auto [place, is_new] = solids_.try_emplace(shape);
  if (is_new) {
    auto solid = std::make_shared<const render::Solid>(solid_from(*shape));
    if (!solid->corners.empty()) place->second = std::move(solid);
  }
  return place->second;
}

void PictureSource::add_throws(const StepRecord& step) {
  infos_.add(step.extras.bodies, step.extras.shapes);
  for (const sim::Command& command : step.inputs) {
    if (const auto* thrown = std::get_if<sim::Throw>(&command)) boxes_.emplace(thrown->box.id, thrown->box);
  }
}

// A state has no sizes or looks; the scene and the throws have. Throws are searched for only when an unknown id turns
// up, from the last searched step on, so a log without throws is never read through.
Result<const sim::BoxDef*> PictureSource::find_box(sim::BodyId id, std::uint64_t k) {
  auto found = boxes_.find(id);
  for (; found == boxes_.end() && scanned_ < k; found = boxes_.find(id)) {
    ++scanned_;
    // Skips a step that cannot be read: it may lie in a damaged part that this picture does not need.
    const Result<const StepRecord*> record = log_->read_hashes(scanned_);
    if (record.ok()) add_throws(**record);
  }
  if (found != boxes_.end()) return &found->second;
  return damaged(log_->name() + ": body " + std::to_string(id) + " at step " + std::to_string(k) +
                 " is in neither the scene nor a readable throw before, so its size is not known");
}

Result<Picture> PictureSource::read(std::uint64_t k, const PictureOptions& options) {
  const Result<const StepRecord*> found = states_.read(k);
  if (!found.ok()) return found.error();
  const StepRecord record = **found;  // a copy, because the search for throws reads other steps of the log
  Picture picture;
  picture.step = k;
  picture.state_hash = record.state_hash;
  picture.dt = record.dt;
  Snapshot& snapshot = picture.snapshot;
  const sim::SceneDef& scene = log_->header().scene;
  snapshot.ground = scene.world.ground;
  snapshot.camera = options.camera.value_or(scene.camera);
  snapshot.light = scene.light;
  picture.not_finite = first_not_finite(record.states, k);
  if (picture.not_finite) picture.not_finite = in_axes(log_->header().axes(), *picture.not_finite);
  for (std::size_t row = 0; row < record.states.size(); ++row) {
    const Result<const sim::BoxDef*> box = find_box(record.states.id[row], k);
    if (!box.ok()) return box.error();
    if (picture.not_finite && !is_finite(record.states, row)) continue;
    snapshot.boxes.push_back(look_of(record.states, row, **box, options));
    BoxLook& look = snapshot.boxes.back();
    look.solid = solid_of(look.id);
    // A crate's bands lie on the edges that a solid lacks.
    if (look.solid && look.texture == sim::Texture::kCrate) look.texture = sim::Texture::kWood;
  }
  if (options.bounds) add_bounds_markers(snapshot);
  if (options.velocities) add_velocity_markers(snapshot, kArrowSeconds);
  if (options.contacts && k > log_->first_state()) {
    if (const Status added = add_contacts(k, snapshot); !added.ok()) return added.error();
  }
  return picture;
}

// Contacts are in no log; the step is simulated again. A player that is at most 64 steps behind is stepped on, which
// costs less than decoding a keyframe and starting from there.
Status PictureSource::add_contacts(std::uint64_t k, Snapshot& snapshot) {
  if (!player_ || player_->world().state().step >= k || player_->world().state().step + 64 < k) {
    player_.reset();
    Result<Player> player = Player::at(*log_, k - 1);
    if (!player.ok()) return player.error();
    player_ = *std::move(player);
  }
  if (Status ok = player_->step_to(k); !ok.ok()) {
    player_.reset();
    return ok;
  }
  add_contact_markers(player_->world(), snapshot);
  return {};
}

// Merges two lists of boxes, both by ascending id.
Snapshot overlay(const Snapshot& ours, const Snapshot& theirs) {
  SIM_DCHECK(std::ranges::is_sorted(ours.boxes, {}, &BoxLook::id));
  SIM_DCHECK(std::ranges::is_sorted(theirs.boxes, {}, &BoxLook::id));
  Snapshot both = ours;
  both.boxes.clear();
  auto other = theirs.boxes.begin();
  for (const BoxLook& box : ours.boxes) {
    for (; other != theirs.boxes.end() && other->id < box.id; ++other) both.boxes.push_back(coloured(*other, kTheirs));
    const bool is_shared = other != theirs.boxes.end() && other->id == box.id;
    if (is_shared && same_pose(box, *other)) {
      both.boxes.push_back(box);
    } else {
      both.boxes.push_back(coloured(box, kOurs));
      if (is_shared) both.boxes.push_back(coloured(*other, kTheirs));
    }
    if (is_shared) ++other;
  }
  for (; other != theirs.boxes.end(); ++other) both.boxes.push_back(coloured(*other, kTheirs));
  return both;
}

}  // namespace tumble::replay
