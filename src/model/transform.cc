#include "tumble/sim/transform.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "src/base/rng.h"
#include "src/base/text.h"
#include "src/math/grid.h"
#include "src/model/command_fields.h"

namespace tumble::sim {
namespace {

/// Transforms the fields of a box or an input in place, each by its role. Positions and velocities are rounded to
/// their grids first, as a world would.
struct TransformFields {
  const Transform& transform;
  const IdMap& ids;

  void operator()(role::Body, BodyId& id) const { id = image_of(id, ids); }
  void operator()(role::Extents, Vec3& size) const { size = transform.extents(size); }
  void operator()(role::Point, Vec3& p) const { p = transform.point(PositionGrid::round(p)); }
  void operator()(role::Rotation, Quat& q) const { q = transform.orientation(q); }
  void operator()(role::Velocity, Vec3& v) const { v = transform.vector(VelocityGrid::round(v)); }
  void operator()(role::Spin, Vec3& w) const { w = transform.axial_vector(VelocityGrid::round(w)); }
  void operator()(role::Vector, Vec3& v) const { v = transform.vector(v); }
  void operator()(role::Plain, const auto&) const {}
  void operator()(role::Look, const auto&) const {}
  void operator()(role::Part, auto& part) const { for_each_field(part, *this); }
};

}  // namespace

Vec3 Transform::vector(const Vec3& v) const {
  const Vec3 mirrored(mirror_x ? -v.x() : v.x(), mirror_y ? -v.y() : v.y(), v.z());
  return sim::plus_zero(swap_xy ? Vec3(mirrored.y(), mirrored.x(), mirrored.z()) : mirrored);
}

Vec3 Transform::point(const Vec3& v) const { return sim::plus_zero(vector(v) + shift); }

Vec3 Transform::axial_vector(const Vec3& w) const {
  const Vec3 v = vector(w);
  return sim::plus_zero(reflects() ? Vec3(-v) : v);
}

Quat Transform::orientation(const Quat& q) const {
  const Vec3 v = axial_vector({q.x, q.y, q.z});
  return {sim::plus_zero(q.w), v.x(), v.y(), v.z()};
}

Vec3 Transform::extents(const Vec3& size) const { return swap_xy ? Vec3(size.y(), size.x(), size.z()) : size; }

bool Transform::identity() const { return *this == Transform(); }

std::string to_string(const Transform& transform) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (transform.mirror_x) add("mirror x");
  if (transform.mirror_y) add("mirror y");
  if (transform.swap_xy) add("mirror diagonal");
  if (transform.shift != Vec3(0, 0, 0)) add("shift " + exact(transform.shift.x()) + "," + exact(transform.shift.y()));
  if (transform.permute) add("permute " + std::to_string(*transform.permute));
  return text.empty() ? "identity" : text;
}

IdMap ids_under(const SceneDef& scene, const Transform& transform) {
  std::vector<BodyId> ids;
  ids.reserve(scene.boxes.size());
  for (const BoxDef& box : scene.boxes) ids.push_back(box.id);
  for (const TimedCommand& input : scene.inputs) {
    if (const auto* thrown = std::get_if<Throw>(&input.command)) ids.push_back(thrown->box.id);
  }
  std::vector<BodyId> new_ids = ids;
  if (transform.permute) {  // Fisher-Yates
    for (std::size_t k = new_ids.size(); k > 1; --k) {
      std::swap(new_ids[k - 1], new_ids[random_bits(*transform.permute, k, 0) % k]);
    }
  }
  IdMap map;
  for (std::size_t k = 0; k < ids.size(); ++k) map[ids[k]] = new_ids[k];
  return map;
}

BodyId image_of(BodyId id, const IdMap& ids) {
  const auto found = ids.find(id);
  return found == ids.end() ? id : found->second;
}

BoxDef image_of(const BoxDef& box, const Transform& transform, const IdMap& ids) {
  BoxDef image = box;
  for_each_field(image, TransformFields{transform, ids});
  return image;
}

Command image_of(const Command& command, const Transform& transform, const IdMap& ids) {
  Command image = command;
  for_each_field(image, TransformFields{transform, ids});
  return image;
}

SceneDef image_of(const SceneDef& scene, const Transform& transform, const IdMap& ids) {
  SceneDef image = scene;
  image.world.gravity = transform.vector(scene.world.gravity);
  for (BoxDef& box : image.boxes) box = image_of(box, transform, ids);
  std::ranges::sort(image.boxes, {}, &BoxDef::id);
  for (TimedCommand& input : image.inputs) input.command = image_of(input.command, transform, ids);
  image.camera.position = transform.point(scene.camera.position);
  image.camera.target = transform.point(scene.camera.target);
  image.light.position = transform.point(scene.light.position);
  image.light.target = transform.point(scene.light.target);
  return image;
}

SceneDef on_grids(const SceneDef& scene) { return image_of(scene, Transform(), IdMap()); }

}  // namespace tumble::sim
