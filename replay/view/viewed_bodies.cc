#include "replay/view/viewed_bodies.h"

#include <variant>

namespace tumble::replay {

ViewedBodies::ViewedBodies(const LogHeader& header) {
  for (const sim::BoxDef& box : header.scene.boxes) define(box);
  infos_.add(header.declared.bodies, header.declared.shapes);
}

void ViewedBodies::define(const sim::BoxDef& box) {
  ViewedBody& body = bodies_[row_of(box.id)];
  if (body.known()) return;
  body = {box.id, box.size, box.mass, box.is_static, box.material.texture, box.origin};
  ++version_;
}

void ViewedBodies::add(const std::vector<sim::Command>& inputs, const Extras& extras) {
  if (!extras.bodies.empty() || !extras.shapes.empty()) {
    infos_.add(extras.bodies, extras.shapes);
    ++version_;
  }
  for (const sim::Command& input : inputs) {
    if (const auto* thrown = std::get_if<sim::Throw>(&input)) define(thrown->box);
  }
}

std::size_t ViewedBodies::row_of(sim::BodyId id) {
  const auto [place, is_new] = rows_.try_emplace(id, bodies_.size());
  if (is_new) {
    bodies_.emplace_back().id = id;
    ++version_;
  }
  return place->second;
}

}  // namespace tumble::replay
