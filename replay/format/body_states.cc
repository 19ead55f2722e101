#include "tumble/replay/body_states.h"

#include <cstring>

namespace tumble::replay {
namespace {

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

template <class States>
bool same_visible(const States& a, const States& b) {
  if (a.id != b.id || a.frozen != b.frozen) return false;
  const ConstColumns columns_a = columns_of(a);
  const ConstColumns columns_b = columns_of(b);
  for (std::size_t c = 0; c < kColumnCount; ++c) {
    if (!same_bits(*columns_a[c], *columns_b[c])) return false;
  }
  return true;
}

}  // namespace

void copy_visible(const sim::Bodies& bodies, BodyStates& states) {
  states.id = bodies.id;
  states.position = bodies.position;
  states.orientation = bodies.orientation;
  states.velocity = bodies.velocity;
  states.spin = bodies.spin;
  states.frozen = bodies.frozen;
}

Hash128 state_hash(const BodyStates& states) {
  sim::Bodies bodies;
  bodies.id = states.id;
  bodies.position = states.position;
  bodies.orientation = states.orientation;
  bodies.velocity = states.velocity;
  bodies.spin = states.spin;
  bodies.frozen = states.frozen;
  return sim::state_hash(bodies);
}

bool same_bits(const BodyStates& a, const BodyStates& b) { return same_visible(a, b); }
bool same_visible_bits(const sim::Bodies& a, const sim::Bodies& b) { return same_visible(a, b); }

}  // namespace tumble::replay
