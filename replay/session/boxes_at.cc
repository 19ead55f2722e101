#include "replay/session/boxes_at.h"

#include <algorithm>
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

}  // namespace

std::vector<sim::BoxDef> boxes_at(const sim::Bodies& bodies, std::vector<sim::BoxDef> known) {
  std::ranges::stable_sort(known, {}, &sim::BoxDef::id);
  std::vector<sim::BoxDef> boxes;
  boxes.reserve(bodies.size());
  for (sim::BodyIndex i = 0; i < bodies.size(); ++i) {
    const auto def = std::ranges::lower_bound(known, bodies.id[i], {}, &sim::BoxDef::id);
    sim::BoxDef box = def != known.end() && def->id == bodies.id[i] ? *def : box_of(bodies, i);
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
