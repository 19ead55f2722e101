#include "replay/diff/step_contacts.h"

#include <algorithm>
#include <set>

#include "replay/format/chain.h"
#include "src/world/scratch.h"
#include "tumble/replay/player.h"

namespace tumble::replay {
namespace {

/// With the lower id first.
StepContact contact_of(const sim::World& world, sim::BodyIndex a, sim::BodyIndex b, const sim::Vec3& normal) {
  StepContact contact;
  contact.normal = normal;
  const auto& ids = world.bodies().id;
  if (a == sim::kGround || b == sim::kGround) {
    contact.a = ids[a == sim::kGround ? b : a];
    if (b == sim::kGround) contact.normal = -normal;
    return contact;
  }
  contact.a = std::min(ids[a], ids[b]);
  contact.b = std::max(ids[a], ids[b]);
  if (ids[a] > ids[b]) contact.normal = -normal;
  return contact;
}

/// Method thesis resolves single contact points, in every substep.
void add_thesis(const sim::World& world, std::uint32_t substep, std::vector<StepContact>& out) {
  const sim::Contacts& contacts = world.scratch().contacts;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    StepContact contact = contact_of(world, contacts.a[i], contacts.b[i], contacts.normal[i]);
    contact.substep = substep;
    contact.depth = contacts.depth[i];
    contact.impulse = sim::length(contacts.impulse[i]);
    out.push_back(contact);
  }
}

/// Method layered solves manifolds of several points: one contact a manifold, with the deepest point and the sum of
/// the impulses.
void add_layered(const sim::World& world, std::uint32_t substep, std::vector<StepContact>& out) {
  const sim::Scratch& scratch = world.scratch();
  for (const sim::Manifold& manifold : scratch.manifolds) {
    const auto points = sim::points_of(scratch, manifold);
    if (manifold.asleep || points.empty()) continue;
    StepContact contact = contact_of(world, manifold.a, manifold.b, manifold.n);
    contact.substep = substep;
    contact.depth = -points.front().separation;
    for (const sim::ManifoldPoint& point : points) {
      contact.depth = std::max(contact.depth, -point.separation);
      contact.impulse += point.impulse;
    }
    out.push_back(contact);
  }
}

}  // namespace

// Scratch holds the contacts with their final impulses only after the last phase; later steps overwrite them.
void ContactCollector::phase_done(std::uint32_t substep, std::size_t phase, const sim::World& world) {
  const sim::Method method = world.state().def.method;
  if (phase + 1 != sim::phase_table(method).phases.size()) return;
  method == sim::Method::kThesis ? add_thesis(world, substep, contacts_) : add_layered(world, substep, contacts_);
}

// Compares by chain links from one common start value: equal links mean equal records.
Result<RetakenStep> retake_step(LogReader& log, std::uint64_t k) {
  if (k <= log.first_state() || k > log.last_step()) {
    return bad_input(log.name() + ": found no step " + std::to_string(k) + " to take again");
  }
  Result<Player> player = Player::at(log, k - 1);
  if (!player.ok()) return player.error();
  ContactCollector collector;
  const Result<const StepRecord*> taken = player->step(&collector);
  if (!taken.ok()) return taken.error();
  Result<const StepRecord*> logged = log.read_hashes(k);
  if (!logged.ok()) return logged.error();
  StepRecord ours = **taken;
  leave_out_phase_words(log.header(), header_for(log.header().scene), **logged, ours);
  return RetakenStep{chain_next({}, **logged) == chain_next({}, ours), **taken, collector.contacts()};
}

// A difference in one contact shows in both of its bodies at once. So a contact between two differing bodies is the
// first suspect, in solver order; else the first differing body's only partner. With several partners any choice would
// be a guess, and there is none.
std::optional<std::pair<sim::BodyId, sim::BodyId>> pair_of(const std::vector<sim::BodyId>& differing,
                                                           const std::vector<StepContact>& contacts) {
  if (differing.empty()) return std::nullopt;
  const auto differs = [&](sim::BodyId id) { return std::ranges::binary_search(differing, id); };
  std::set<std::pair<sim::BodyId, sim::BodyId>> of_first;
  for (const StepContact& contact : contacts) {
    if (!contact.b) continue;
    if (differs(contact.a) && differs(*contact.b)) return std::pair(contact.a, *contact.b);
    if (contact.has(differing.front())) of_first.emplace(contact.a, *contact.b);
  }
  if (of_first.size() == 1) return *of_first.begin();
  return std::nullopt;
}

std::string describe(const StepContact& contact) {
  const auto number = [](double value) { return to_string(FieldValue(value)); };
  return std::to_string(contact.a) + " and " + (contact.b ? std::to_string(*contact.b) : "the ground") + ": depth " +
         number(contact.depth) + " m, impulse " + number(contact.impulse) + " N s, normal " +
         number(contact.normal.x()) + ' ' + number(contact.normal.y()) + ' ' + number(contact.normal.z()) +
         ", substep " + std::to_string(contact.substep);
}

}  // namespace tumble::replay
