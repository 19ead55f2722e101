#include "replay/import/known_bodies.h"

#include <span>
#include <string>
#include <variant>

namespace tumble::replay {
namespace {

Status comes_back(sim::BodyId id, const char* with) {
  return bad_input("body " + std::to_string(id) + ": was removed before and comes back with another " + with +
                   "; wanted the same body, or an id that no body had");
}

Hash128 hash_of_both(const BodyInfo& info) {
  const Hash128 name = hash_bytes(std::as_bytes(std::span(info.name)));
  Hasher hasher;
  for (const std::uint64_t word : {name.high, name.low, info.shape.high, info.shape.low}) hasher.add(word);
  return hasher.digest();
}

}  // namespace

Status KnownBodies::see(const sim::Command& input, const sim::Bodies& bodies) {
  if (const auto* gone = std::get_if<sim::Remove>(&input)) remove(bodies, gone->id);
  const auto* thrown = std::get_if<sim::Throw>(&input);
  return thrown != nullptr ? check(thrown->box) : Status();
}

void KnownBodies::remove(const sim::Bodies& bodies, sim::BodyId id) {
  const std::optional<sim::BodyIndex> row = bodies.find(id);
  if (!row) return;
  sim::BoxDef& box = removed_[id];
  box.size = bodies.half_extent[*row] * 2;
  box.mass = bodies.mass[*row];
  box.is_static = bodies.is_static[*row] != 0;
  box.material.friction = bodies.friction[*row];
  box.material.friction_dynamic = bodies.friction_dynamic[*row];
  box.material.restitution = bodies.restitution[*row];
}

Status KnownBodies::check(const sim::BoxDef& box) const {
  const auto found = removed_.find(box.id);
  if (found == removed_.end()) return {};
  const sim::BoxDef& before = found->second;
  const sim::Vec3 half = box.size * 0.5;  // as a world keeps it
  if (sim::Vec3(half * 2) != before.size) return comes_back(box.id, "size");
  if (box.mass != before.mass) return comes_back(box.id, "mass");
  if (box.is_static != before.is_static) return comes_back(box.id, "kind (static or not)");
  const bool same = box.material.friction == before.material.friction &&
                    box.material.friction_dynamic == before.material.friction_dynamic &&
                    box.material.restitution == before.material.restitution;
  return same ? Status() : comes_back(box.id, "material");
}

Status KnownBodies::describe(const BodyInfo& info) {
  const auto [place, is_new] = described_.emplace(info.id, hash_of_both(info));
  return is_new || place->second == hash_of_both(info) ? Status() : comes_back(info.id, "name or shape");
}

}  // namespace tumble::replay
