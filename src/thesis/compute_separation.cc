#include "src/thesis/compute_separation.h"

#include <algorithm>

#include "src/math/grid.h"

namespace tumble::sim {
namespace {

// During the merge `displacement` holds the largest positive part of each axis, `displacement_low` the largest
// negative.
void merge(Scratch& scratch, BodyIndex i, const Vec3& displacement) {
  const Vec3 d = PositionGrid::round(displacement);
  scratch.displacement.set(i, scratch.displacement[i].cwiseMax(d));
  scratch.displacement_low.set(i, scratch.displacement_low[i].cwiseMin(d));
}

// Adds the negative parts and sets them to zero, so that a second call for a body adds nothing.
void add_low(Scratch& scratch, BodyIndex i) {
  scratch.displacement.add(i, scratch.displacement_low[i]);
  scratch.displacement_low.set(i, Vec3::Zero());
}

double give_way(const Bodies& bodies, BodyIndex i) {
  return i != kGround && bodies.moves(i) ? bodies.inverse_mass[i] : 0;
}

}  // namespace

Status compute_separation(WorldState& state, Scratch& scratch, double /*dt_s*/) {
  const Bodies& bodies = state.bodies;
  const Contacts& contacts = scratch.contacts;
  const std::size_t n = bodies.size();
  scratch.displacement.assign(n, Vec3::Zero());
  scratch.displacement_low.assign(n, Vec3::Zero());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const BodyIndex a = contacts.a[k], b = contacts.b[k];
    const double share_a = give_way(bodies, a), share_b = give_way(bodies, b);
    const double total = share_a + share_b;
    if (total == 0) continue;
    const Vec3 normal = contacts.normal[k];
    if (share_a > 0) merge(scratch, a, normal * (-contacts.depth[k] * share_a / total));
    if (share_b > 0) merge(scratch, b, normal * (contacts.depth[k] * share_b / total));
  }
  for (const std::vector<BodyIndex>* side : {&contacts.a, &contacts.b}) {
    for (const BodyIndex i : *side) {
      if (i != kGround) add_low(scratch, i);
    }
  }
  return {};
}

void hash_compute_separation(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  const Vec3Column& displacement = scratch.displacement;
  for (const auto* column : {&displacement.x, &displacement.y, &displacement.z}) {
    hasher.add(std::span<const double>(*column));
  }
}

}  // namespace tumble::sim
