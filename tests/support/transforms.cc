#include "tests/support/transforms.h"

#include <algorithm>
#include <array>
#include <bit>

#include "src/math/grid.h"
#include "tests/support/sim_scenes.h"

namespace tumble::test {

using sim::BodyId;
using sim::BoxDef;
using sim::Command;
using sim::PositionGrid;
using sim::Quat;
using sim::SceneDef;
using sim::Vec3;
using sim::VelocityGrid;

namespace {

BoxDef resolved_box(BoxDef box) {
  box.position = PositionGrid::round(box.position);
  box.velocity = VelocityGrid::round(box.velocity);
  box.spin = VelocityGrid::round(box.spin);
  box.orientation = normalised(box.orientation);
  return box;
}

void sort_by_id(std::vector<BoxDef>& boxes) { std::ranges::sort(boxes, {}, &BoxDef::id); }

// The bits of everything that is compared of a body.
using BodyBits = std::array<std::uint64_t, 15>;
BodyBits bits_of(const Vec3& x, const Quat& q, const Vec3& v, const Vec3& w, std::uint8_t frozen, double time) {
  const std::array<double, 14> values = {x.x(), x.y(), x.z(), q.w,   q.x,   q.y,   q.z,
                                         v.x(), v.y(), v.z(), w.x(), w.y(), w.z(), time};
  BodyBits bits;
  for (std::size_t k = 0; k < values.size(); ++k) bits[k] = std::bit_cast<std::uint64_t>(values[k]);
  bits[14] = frozen;
  return bits;
}

Quat plus_zero(const Quat& q) { return {q.w + 0.0, q.x + 0.0, q.y + 0.0, q.z + 0.0}; }

}  // namespace

Vec3 Transform::vector(const Vec3& v) const {
  const Vec3 mirrored(mirror_x ? -v.x() : v.x(), mirror_y ? -v.y() : v.y(), v.z());
  return sim::plus_zero(swap_xy ? Vec3(mirrored.y(), mirrored.x(), mirrored.z()) : mirrored);
}

Vec3 Transform::point(const Vec3& v) const { return sim::plus_zero(vector(v) + shift); }

Vec3 Transform::axial_vector(const Vec3& w) const {
  const bool reflected = (static_cast<int>(mirror_x) + static_cast<int>(mirror_y) + static_cast<int>(swap_xy)) % 2 == 1;
  const Vec3 v = vector(w);
  return sim::plus_zero(reflected ? Vec3(-v) : v);
}

Quat Transform::orientation(const Quat& q) const {
  const Vec3 v = axial_vector({q.x, q.y, q.z});
  return plus_zero({q.w, v.x(), v.y(), v.z()});
}

Vec3 Transform::extents(const Vec3& size) const { return swap_xy ? Vec3(size.y(), size.x(), size.z()) : size; }

const std::vector<Transform>& all_transforms() {
  static const std::vector<Transform> kAll = [] {
    std::vector<Transform> all(6);
    all[0].name = "mirror x";
    all[0].mirror_x = true;
    all[1].name = "mirror y";
    all[1].mirror_y = true;
    all[2].name = "swap x and y";
    all[2].swap_xy = true;
    all[3].name = "shift";
    all[3].shift = {1024, -512.5, 0};
    all[4].name = "permuted ids";
    all[4].permute_ids = true;
    all[5] = {"all at once", true, true, true, {-37.25, 4096, 0}, true};
    return all;
  }();
  return kAll;
}

SceneDef resolved(SceneDef scene) {
  for (BoxDef& box : scene.boxes) box = resolved_box(box);
  for (sim::TimedCommand& input : scene.inputs) {
    if (auto* thrown = std::get_if<sim::Throw>(&input.command)) thrown->box = resolved_box(thrown->box);
    if (auto* push = std::get_if<sim::Push>(&input.command)) push->at = PositionGrid::round(push->at);
    if (auto* set = std::get_if<sim::SetVelocity>(&input.command)) {
      set->velocity = VelocityGrid::round(set->velocity);
      set->spin = VelocityGrid::round(set->spin);
    }
  }
  return scene;
}

Names names_under(const SceneDef& scene, const Transform& transform, std::uint64_t seed) {
  std::vector<BodyId> ids;
  for (const BoxDef& box : scene.boxes) ids.push_back(box.id);
  for (const sim::TimedCommand& input : scene.inputs) {
    if (const auto* thrown = std::get_if<sim::Throw>(&input.command)) ids.push_back(thrown->box.id);
  }
  std::vector<BodyId> new_ids = ids;
  Random random(seed);
  if (transform.permute_ids) shuffle(new_ids, random);
  Names names;
  for (std::size_t k = 0; k < ids.size(); ++k) names[ids[k]] = new_ids[k];
  return names;
}

BoxDef image_of(const BoxDef& box, const Transform& transform, const Names& names) {
  BoxDef image = box;
  image.id = names.at(box.id);
  image.size = transform.extents(box.size);
  image.position = transform.point(box.position);
  image.orientation = transform.orientation(box.orientation);
  image.velocity = transform.vector(box.velocity);
  image.spin = transform.axial_vector(box.spin);
  return image;
}

Command image_of(const Command& command, const Transform& transform, const Names& names) {
  struct Image {
    const Transform& t;
    const Names& names;
    Command operator()(const sim::Throw& c) const { return sim::Throw{image_of(c.box, t, names)}; }
    Command operator()(const sim::Push& c) const {
      return sim::Push{names.at(c.id), t.vector(c.impulse), c.at_centre, t.point(c.at)};
    }
    Command operator()(const sim::Remove& c) const { return sim::Remove{names.at(c.id)}; }
    Command operator()(const sim::Wake& c) const { return sim::Wake{names.at(c.id)}; }
    Command operator()(const sim::SetVelocity& c) const {
      return sim::SetVelocity{names.at(c.id), t.vector(c.velocity), t.axial_vector(c.spin)};
    }
    Command operator()(const sim::SetGravity& c) const { return sim::SetGravity{t.vector(c.gravity)}; }
    Command operator()(const sim::SetDt& c) const { return c; }
  };
  return std::visit(Image{transform, names}, command);
}

SceneDef image_of(const SceneDef& scene, const Transform& transform, const Names& names) {
  SceneDef image = scene;
  image.world.gravity = transform.vector(scene.world.gravity);
  for (BoxDef& box : image.boxes) box = image_of(box, transform, names);
  sort_by_id(image.boxes);
  for (sim::TimedCommand& input : image.inputs) input.command = image_of(input.command, transform, names);
  return image;
}

std::size_t differing_bodies(const sim::World& original, const sim::World& image, const Transform& transform,
                             const Names& names) {
  const sim::Bodies& from = original.bodies();
  const sim::Bodies& to = image.bodies();
  std::size_t different = to.size() > from.size() ? to.size() - from.size() : 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const auto j = to.find(names.at(from.id[i]));
    if (!j) {
      ++different;
      continue;
    }
    const BodyBits wanted = bits_of(transform.point(from.position[i]), transform.orientation(from.orientation[i]),
                                    transform.vector(from.velocity[i]), transform.axial_vector(from.spin[i]),
                                    from.frozen[i], from.low_energy_time[i]);
    const BodyBits found = bits_of(to.position[*j], to.orientation[*j], to.velocity[*j], to.spin[*j], to.frozen[*j],
                                   to.low_energy_time[*j]);
    if (wanted != found) ++different;
  }
  return different;
}

}  // namespace tumble::test
