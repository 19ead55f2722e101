#include "replay/session/boxes_at.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace tumble::replay {
namespace {

sim::BoxDef box_of(const sim::Bodies& bodies, sim::BodyIndex i) {
  sim::BoxDef box;
  box.id = bodies.id[i];
  box.size = bodies.half_extent[i] * 2;  // exact: a factor of two changes no bit of the fraction
  box.mass = bodies.mass[i];
  box.is_static = bodies.is_static[i] != 0;
  box.material.friction = bodies.friction[i];
  box.material.friction_dynamic = bodies.friction_dynamic[i];
  box.material.restitution = bodies.restitution[i];
  return box;
}

/// Whether a box made this body. The last box of an id does, but a list may lack it: an id is free again once its body
/// is removed.
bool is_of(const sim::BoxDef& box, const sim::Bodies& bodies, sim::BodyIndex i) {
  const sim::Vec3 half = box.size * 0.5;
  return box.id == bodies.id[i] && half == bodies.half_extent[i] && box.mass == bodies.mass[i] &&
         box.is_static == (bodies.is_static[i] != 0) && box.material.friction == bodies.friction[i] &&
         box.material.friction_dynamic == bodies.friction_dynamic[i] &&
         box.material.restitution == bodies.restitution[i];
}

}  // namespace

std::vector<sim::BoxDef> boxes_at(const sim::Bodies& bodies, std::vector<sim::BoxDef> known) {
  std::ranges::stable_sort(known, {}, &sim::BoxDef::id);
  std::vector<sim::BoxDef> boxes;
  boxes.reserve(bodies.size());
  for (sim::BodyIndex i = 0; i < bodies.size(); ++i) {
    const auto behind = std::ranges::upper_bound(known, bodies.id[i], {}, &sim::BoxDef::id);
    const bool is_known = behind != known.begin() && is_of(*std::prev(behind), bodies, i);
    sim::BoxDef box = is_known ? *std::prev(behind) : box_of(bodies, i);
    box.position = bodies.position[i];
    box.orientation = bodies.orientation[i];
    box.velocity = bodies.velocity[i];
    box.spin = bodies.spin[i];
    box.frozen = bodies.frozen[i] != 0;
    boxes.push_back(std::move(box));
  }
  return boxes;
}

}  // namespace tumble::replay
