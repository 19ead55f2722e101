#include "tumble/replay/body_table.h"

namespace tumble::replay {

void BodyTable::add(const std::vector<BodyInfo>& bodies, const std::vector<Shape>& shapes) {
  for (const Shape& shape : shapes) {
    const Hash128 hash = hash_of(shape);
    shapes_.emplace(std::pair(hash.high, hash.low), shape);
  }
  for (const BodyInfo& body : bodies) {
    BodyInfo& known = bodies_.emplace(body.id, body).first->second;
    if (known.name.empty()) known.name = body.name;
    if (known.shape == Hash128()) known.shape = body.shape;
  }
}

std::string BodyTable::name(sim::BodyId id) const {
  const auto body = bodies_.find(id);
  return body == bodies_.end() ? "" : body->second.name;
}

const Shape* BodyTable::shape(sim::BodyId id) const {
  const auto body = bodies_.find(id);
  if (body == bodies_.end()) return nullptr;
  const auto shape = shapes_.find({body->second.shape.high, body->second.shape.low});
  return shape == shapes_.end() ? nullptr : &shape->second;
}

std::string BodyTable::text(sim::BodyId id) const {
  const std::string named = name(id);
  if (!named.empty() && id >= kIdsOfNames) return "body " + named;
  return "body " + std::to_string(id) + (named.empty() ? "" : " (" + named + ")");
}

}  // namespace tumble::replay
