#include "src/model/transform.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "src/base/rng.h"
#include "src/base/text.h"
#include "src/math/grid.h"

namespace tumble::sim {
namespace {

BoxDef on_grids(BoxDef box) {
  box.position = PositionGrid::round(box.position);
  box.velocity = VelocityGrid::round(box.velocity);
  box.spin = VelocityGrid::round(box.spin);
  return box;
}

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
  BoxDef image = on_grids(box);
  image.id = image_of(box.id, ids);
  image.size = transform.extents(image.size);
  image.position = transform.point(image.position);
  image.orientation = transform.orientation(image.orientation);
  image.velocity = transform.vector(image.velocity);
  image.spin = transform.axial_vector(image.spin);
  return image;
}

Command image_of(const Command& command, const Transform& transform, const IdMap& ids) {
  struct Image {
    const Transform& t;
    const IdMap& ids;
    Command operator()(const Throw& c) const { return Throw{image_of(c.box, t, ids)}; }
    Command operator()(const Push& c) const {
      return Push{image_of(c.id, ids), t.vector(c.impulse), c.at_centre, t.point(PositionGrid::round(c.at))};
    }
    Command operator()(const Remove& c) const { return Remove{image_of(c.id, ids)}; }
    Command operator()(const Wake& c) const { return Wake{image_of(c.id, ids)}; }
    Command operator()(const SetVelocity& c) const {
      return SetVelocity{image_of(c.id, ids), t.vector(VelocityGrid::round(c.velocity)),
                         t.axial_vector(VelocityGrid::round(c.spin))};
    }
    Command operator()(const SetGravity& c) const { return SetGravity{t.vector(c.gravity)}; }
    Command operator()(const SetDt& c) const { return c; }
  };
  return std::visit(Image{transform, ids}, command);
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
