#include "src/thesis/compute_separation.h"

#include <cstddef>
#include <span>

#include "src/math/grid.h"
#include "src/thesis/merge_displacements.h"
#include "src/world/hash_on_the_way.h"

namespace tumble::sim {
namespace {

double give_way(const Bodies& bodies, BodyIndex i) {
  return i != kGround && bodies.moves(i) ? bodies.inverse_mass[i] : 0;
}

// Calls visit(body, displacement) for each side of each contact that gives way.
template <class Visit>
void for_each_displacement(const Bodies& bodies, const Contacts& contacts, Visit visit) {
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const BodyIndex a = contacts.a[k], b = contacts.b[k];
    const double share_a = give_way(bodies, a), share_b = give_way(bodies, b);
    const double total = share_a + share_b;
    const bool shared = share_a > 0 && share_b > 0;
    const Vec3 normal = contacts.normal[k];
    if (share_a > 0) visit(a, Displacement{-normal, contacts.depth[k] * share_a / total, shared});
    if (share_b > 0) visit(b, Displacement{normal, contacts.depth[k] * share_b / total, shared});
  }
}

// Lists the displacements body by body.
void collect(const Bodies& bodies, const Contacts& contacts, SeparationScratch& own) {
  own.start.assign(bodies.size() + 1, 0);
  for_each_displacement(bodies, contacts, [&](BodyIndex i, const Displacement&) { ++own.start[i]; });
  std::uint32_t end = 0;
  for (std::uint32_t& start : own.start) start = end += start;
  own.wanted.resize(end);
  for_each_displacement(bodies, contacts,
                        [&](BodyIndex i, const Displacement& wanted) { own.wanted[--own.start[i]] = wanted; });
}

// Writes no displacement for every body in a contact.
void stay_where_they_are(const Contacts& contacts, Vec3Column& displacement) {
  for (const BodyIndex i : contacts.a) displacement.set(i, Vec3::Zero());
  for (const BodyIndex i : contacts.b) {
    if (i != kGround) displacement.set(i, Vec3::Zero());
  }
}

}  // namespace

Status compute_separation(WorldState& state, Scratch& scratch, double /*dt_s*/) {
  const std::size_t n = state.bodies.size();
  SeparationScratch& own = scratch.separation;
  collect(state.bodies, scratch.contacts, own);
  scratch.displacement.resize(n);
  stay_where_they_are(scratch.contacts, scratch.displacement);
  for (BodyIndex i = 0; i < n; ++i) {
    const std::size_t count = own.start[i + 1] - own.start[i];
    if (count == 0) continue;
    const std::span<Displacement> wanted = std::span(own.wanted).subspan(own.start[i], count);
    scratch.displacement.set(i, PositionGrid::round(merge_displacements(wanted).displacement));
  }
  return {};
}

void hash_compute_separation(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  add_touched(scratch, hasher,
              [&](GatheredNumbers& numbers, BodyIndex i) { numbers.add(Vec3(scratch.displacement[i])); });
}

}  // namespace tumble::sim
