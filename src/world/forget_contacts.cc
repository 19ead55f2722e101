#include "src/world/forget_contacts.h"

#include <algorithm>

#include "src/world/islands.h"

namespace tumble::sim {
namespace {

// The contacts but those of body i.
ContactMemory without(const ContactMemory& memory, BodyIndex i) {
  ContactMemory kept;
  std::size_t point = 0;
  for (std::size_t k = 0; k < memory.size(); point += memory.count[k], ++k) {
    if (memory.a[k] == i || memory.b[k] == i) continue;
    kept.a.push_back(memory.a[k]);
    kept.b.push_back(memory.b[k]);
    kept.count.push_back(memory.count[k]);
    kept.friction.push_back(memory.friction[k]);
    kept.twist.push_back(memory.twist[k]);
    const auto from = static_cast<std::ptrdiff_t>(point), to = from + static_cast<std::ptrdiff_t>(memory.count[k]);
    kept.feature.insert(kept.feature.end(), memory.feature.begin() + from, memory.feature.begin() + to);
    kept.impulse.insert(kept.impulse.end(), memory.impulse.begin() + from, memory.impulse.begin() + to);
  }
  return kept;
}

}  // namespace

std::vector<BodyIndex> connected_with(const WorldState& state, BodyIndex i) {
  const ContactMemory& memory = state.contact_memory;
  const auto connects = [&](BodyIndex body) { return body == i || state.bodies.is_static[body] == 0; };
  std::vector<BodyIndex> links;
  Islands islands(links, state.bodies.size(), nullptr);
  for (std::size_t k = 0; k < memory.size(); ++k) {
    const BodyIndex a = memory.a[k], b = memory.b[k];
    if (a != kGround && connects(a) && connects(b)) islands.join(a, b);
  }
  std::vector<BodyIndex> found;
  for (BodyIndex body = 0; body < state.bodies.size(); ++body) {
    if (body != i && islands.of(body) == islands.of(i)) found.push_back(body);
  }
  return found;
}

namespace {

void forget(ContactMemory& memory, std::size_t k, std::size_t first_point) {
  memory.friction[k] = Vec3::Zero();
  memory.twist[k] = 0;
  const auto first = memory.impulse.begin() + static_cast<std::ptrdiff_t>(first_point);
  std::fill(first, first + static_cast<std::ptrdiff_t>(memory.count[k]), 0.0);
}

}  // namespace

void forget_impulses(ContactMemory& memory) {
  std::size_t point = 0;
  for (std::size_t k = 0; k < memory.size(); point += memory.count[k], ++k) forget(memory, k, point);
}

std::vector<BodyIndex> forget_contacts(WorldState& state, BodyIndex i) {
  ContactMemory& memory = state.contact_memory;
  std::vector<BodyIndex> connected = connected_with(state, i);
  memory = without(memory, i);
  std::size_t point = 0;
  for (std::size_t k = 0; k < memory.size(); point += memory.count[k], ++k) {
    const auto among = [&](BodyIndex body) { return std::ranges::binary_search(connected, body); };
    if (among(memory.a[k]) || among(memory.b[k])) forget(memory, k, point);
  }
  return connected;
}

}  // namespace tumble::sim
