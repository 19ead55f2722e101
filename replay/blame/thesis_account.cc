// What method thesis leaves of a body's collisions, phase by phase.
#include "replay/blame/body_account.h"

namespace tumble::replay {
namespace {

std::optional<sim::BodyId> other_of(const sim::Contacts& contacts, std::size_t k, sim::BodyIndex row,
                                    const std::vector<sim::BodyId>& ids) {
  const sim::BodyIndex other = contacts.a[k] == row ? contacts.b[k] : contacts.a[k];
  return other == sim::kGround ? std::nullopt : std::optional(ids[other]);
}

// Calls visit(k, side): side 0 where the body is a.
template <class Visit>
void for_each_of(const sim::Contacts& contacts, sim::BodyIndex row, Visit visit) {
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (contacts.a[k] == row) visit(k, 0U);
    if (contacts.b[k] == row) visit(k, 1U);
  }
}

}  // namespace

// Contacts of an earlier substep stay listed: a body may meet one collision in one substep and another in the next.
void AccountObserver::look_thesis(const std::string& phase, std::uint32_t substep, const sim::World& world) {
  const sim::Scratch& scratch = world.scratch();
  const sim::Contacts& contacts = scratch.contacts;
  if (phase == "find_contacts") {
    for_each_of(contacts, row_, [&](std::size_t k, unsigned side) {
      ContactFacts& facts = facts_of(other_of(contacts, k, row_, ids_));
      facts.found_by = phase;
      facts.points = 1;
      facts.normal = side == 1 ? contacts.normal[k] : sim::Vec3(-contacts.normal[k]);
      facts.depth = contacts.depth[k];
      facts.separation = -facts.depth;
      facts.substep = substep;
    });
  }
  if (phase == "compute_impulses") {
    for_each_of(contacts, row_, [&](std::size_t k, unsigned side) {
      const sim::Gain& gain = scratch.split.gains[2 * k + side];
      ContactPart& part = part_of(other_of(contacts, k, row_, ids_));
      part.velocity += gain.velocity;
      part.spin += gain.spin;
      part.position += gain.way_back;
      ContactFacts& facts = facts_of(part.other);
      facts.approach = scratch.split.encounters[k].approach;
      facts.friction = scratch.split.materials[k].friction;
      facts.restitution = scratch.split.materials[k].restitution;
      facts.split = scratch.split.parts[row_];
      facts.rests = gain.way_back != sim::Vec3::Zero();
    });
  }
  if (phase == "compute_separation" && !scratch.separation.wanted.empty()) {
    // Merged displacements have no parts: what each contact asked for stands instead.
    const sim::Bodies& bodies = world.bodies();
    const auto yields = [&](sim::BodyIndex i) {
      return i != sim::kGround && bodies.moves(i) ? bodies.inverse_mass[i] : 0.0;
    };
    for_each_of(contacts, row_, [&](std::size_t k, unsigned side) {
      const double own = yields(row_), total = yields(contacts.a[k]) + yields(contacts.b[k]);
      if (own == 0) return;
      const sim::Vec3 out = side == 1 ? contacts.normal[k] : sim::Vec3(-contacts.normal[k]);
      part_of(other_of(contacts, k, row_, ids_)).position += out * (contacts.depth[k] * own / total);
    });
  }
}

}  // namespace tumble::replay
