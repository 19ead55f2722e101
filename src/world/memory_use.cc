#include "src/world/memory_use.h"

#include "src/world/scratch.h"

namespace tumble::sim {
namespace {

// Capacity in bytes of everything that is made of vectors.
std::size_t held(const Bodies& b);
std::size_t held(const ContactMemory& m);
std::size_t held(const Contacts& c);
std::size_t held(const ManifoldList& list);
std::size_t held(const ContactBatches& b);
std::size_t held(const FastContacts& f);
std::size_t held(const SavedMotion& s);
std::size_t held(const WaveScratch& w);
template <class T, class Allocator>
std::size_t held(const std::vector<T, Allocator>& items) {
  return items.capacity() * sizeof(T);
}
std::size_t held(const Vec3Column& c) { return held(c.x) + held(c.y) + held(c.z); }
std::size_t held(const QuatColumn& c) { return held(c.w) + held(c.x) + held(c.y) + held(c.z); }
std::size_t held(const PairTable& p) { return held(p.a) + held(p.b) + held(p.planes); }
std::size_t held(const ContactObjects& o) { return held(o.body) + held(o.object); }

template <class... Parts>
std::size_t held_by(const Parts&... parts) {
  return (held(parts) + ...);
}

std::size_t held(const Bodies& b) {
  return held_by(b.id, b.position, b.orientation, b.velocity, b.spin, b.frozen, b.low_energy_time, b.half_extent,
                 b.mass, b.inverse_mass, b.inertia, b.inverse_inertia, b.friction, b.friction_dynamic, b.restitution,
                 b.is_static);
}
std::size_t held(const ContactMemory& m) {
  return held_by(m.a, m.b, m.count, m.friction, m.twist, m.feature, m.impulse);
}
std::size_t held(const Contacts& c) {
  return held_by(c.a, c.b, c.planes, c.normal, c.depth, c.r_a, c.r_b, c.patch, c.patch_end, c.impulse);
}
std::size_t held(const ManifoldList& list) { return held_by(list.manifolds, list.points, list.fast_pairs); }
std::size_t held(const ContactBatches& b) {
  std::size_t uses = held(b.uses);
  for (const std::vector<std::uint32_t>& of_worker : b.uses) uses += held(of_worker);
  return uses + held_by(b.batches, b.sides, b.points, b.impacts, b.layer_start, b.place, b.order, b.touched,
                        b.touched_start, b.touched_end, b.counts, b.entries);
}
std::size_t held(const FastContacts& f) {
  return held_by(f.pairs, f.bodies, f.place, f.approaches, f.found, f.memory, f.batches, f.members, f.marked, f.waits,
                 f.unmet);
}
std::size_t held(const WaveScratch& w) {
  return held_by(w.pushed[0], w.pushed[1], w.sent[0], w.sent[1], w.taken, w.start);
}
std::size_t held(const SavedMotion& s) { return held_by(s.position, s.velocity, s.spin, s.orientation, s.pairs); }

template <class T>
std::size_t held_inside(const std::vector<T>& lists) {
  std::size_t bytes = held(lists);
  for (const T& list : lists) bytes += held(list);
  return bytes;
}

void add_state(const WorldState& state, std::vector<MemoryPart>& parts) {
  parts.push_back({"state: bodies", GrowsWith::kBodies, held_by(state.bodies, state.contact_objects)});
  parts.push_back({"state: pairs", GrowsWith::kPairs, held(state.pairs)});
  parts.push_back({"state: contact memory", GrowsWith::kContacts, held(state.contact_memory)});
}

void add_search(const Scratch& s, std::vector<MemoryPart>& parts) {
  const SweepScratch& sweep = s.sweep;
  parts.push_back({"boxes", GrowsWith::kBodies,
                   held_by(s.frames, s.aabb_low, s.aabb_high, s.turning, s.ranges, s.hit_unevenly, s.framed)});
  parts.push_back({"sweep: order and cells", GrowsWith::kBodies,
                   held_by(sweep.order, sweep.judged, sweep.fat_low, sweep.fat_high, sweep.boxes, sweep.start,
                           sweep.next, sweep.entries, sweep.cell_start, sweep.extents)});
  parts.push_back({"sweep: pairs", GrowsWith::kPairs,
                   held_by(sweep.neighbours, sweep.partner, sweep.merged, s.old_planes) + held_inside(sweep.found_by)});
}

void add_layered(const Scratch& s, std::vector<MemoryPart>& parts) {
  const IslandScratch& i = s.islands;
  const WeightScratch& w = s.weights;
  const SweepShares& shares = s.shares;
  parts.push_back({"manifolds", GrowsWith::kContacts,
                   held_by(s.manifolds, s.manifold_points, s.manifold_pieces, s.blocks_left, s.pieces_start,
                           s.pieces_by, s.manifold_ranges) +
                       s.manifold_homes.held() + held_inside(s.manifolds_by)});
  parts.push_back(
      {"layers", GrowsWith::kContacts, held_by(s.layered, s.layer_start, s.sweep_groups, s.graph.links, s.graph.ends)});
  parts.push_back({"weights", GrowsWith::kContacts, held_by(w.supports, w.meets) + held_inside(w.points)});
  parts.push_back({"batches", GrowsWith::kContacts,
                   held_by(s.contact_batches, s.outcomes, s.fast, shares.order, shares.first, shares.heirs, shares.cuts,
                           shares.urgent, shares.copies, shares.touched, shares.touched_first, shares.counts) +
                       held_inside(shares.places)});
  parts.push_back({"solver's bodies", GrowsWith::kBodies,
                   held_by(s.solver_bodies, s.solver_mass, s.lent_along, s.in_contact, s.held, s.visits.moved,
                           s.visits.reach_of_body, s.visits.reach, s.energies, shares.users, shares.copies_before) +
                       held_inside(s.visits.layers)});
  parts.push_back({"levels, islands and sleep", GrowsWith::kBodies,
                   held_by(s.level, s.next_in_layer, i.of, i.hit, i.most_sweeps, i.has_bar, i.sweeps, i.turns, i.hard,
                           i.marked, i.layers, i.reach2, i.heaviest, i.fast, i.hits, s.graph.start, w.start,
                           w.waiting_for, w.meeting, w.borne, w.moment_x, w.moment_y, w.blows, w.first_blow, w.struck,
                           w.stands, w.held, w.settled, w.offered, s.island_links, s.waking.disturbed, s.waking.woken,
                           s.waking.wakes, s.sleeping.touching, s.sleeping.restless, s.sleeping.held,
                           s.sleeping.together, s.sleeping.energy_before, s.graph.alone, s.ends_before) +
                       held_inside(s.waves) + held_inside(s.sent_ends) + s.homes.held()});
}

void add_thesis(const Scratch& s, std::vector<MemoryPart>& parts) {
  const FreezeScratch& f = s.freezing;
  parts.push_back({"contacts", GrowsWith::kContacts,
                   held_by(s.contacts, s.split.gains, s.split.encounters, s.split.materials, s.split.met,
                           s.split.resting, s.split.energy, s.split.again, s.separation.wanted, f.carriers, f.found)});
  parts.push_back({"outcomes and freezing", GrowsWith::kBodies,
                   held_by(s.gains, s.hit, s.displacement, s.separation.start, s.split.parts, s.split.raised,
                           s.split.changed, s.split.several, s.split.contacts, s.split.count, s.split.together,
                           s.split.sum, s.split.magic, s.touched, f.ready, f.candidates, f.frozen_before, f.merged)});
  parts.push_back({"put back after a trial", GrowsWith::kBodies, held_inside(s.saved)});
}

}  // namespace

std::vector<MemoryPart> memory_use(const World& world) {
  std::vector<MemoryPart> parts;
  add_state(world.state(), parts);
  add_search(world.scratch(), parts);
  if (world.state().def.method == Method::kLayered) {
    add_layered(world.scratch(), parts);
  } else {
    add_thesis(world.scratch(), parts);
  }
  return parts;
}

}  // namespace tumble::sim
