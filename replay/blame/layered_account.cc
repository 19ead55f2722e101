// What method layered leaves of a body's contacts, phase by phase.
#include <algorithm>
#include <cmath>

#include "replay/blame/body_account.h"
#include "src/math/grid.h"

namespace tumble::replay {
namespace {

bool of_row(const sim::Manifold& m, sim::BodyIndex row) { return m.a == row || m.b == row; }

std::optional<sim::BodyId> other_of(const sim::Manifold& m, sim::BodyIndex row, const std::vector<sim::BodyId>& ids) {
  const sim::BodyIndex other = m.a == row ? m.b : m.a;
  return other == sim::kGround ? std::nullopt : std::optional(ids[other]);
}

bool in_hard_layer(const sim::Scratch& scratch, const sim::Manifold& m) {
  return std::ranges::any_of(scratch.sweep_groups, [&](const sim::SweepGroup& group) {
    return group.hard && m.layer >= group.begin && m.layer < group.end;
  });
}

// A body at rest is of no island, and has 1.
int sweeps_of(const sim::Scratch& scratch, const sim::Manifold& m) {
  const std::vector<std::uint8_t>& sweeps = scratch.islands.sweeps;
  return m.a == sim::kGround ? sweeps[m.b] : std::max(sweeps[m.a], sweeps[m.b]);
}

}  // namespace

// Rows of outcomes: 2 (k kLanes + lane) for body a of lane `lane` of batch k of the layer, the next for body b.
void AccountObserver::layer_solved(const sim::Scratch& scratch, const sim::ContactBatches& all, std::size_t layer) {
  const bool fast = &all == &scratch.fast.batches;
  const LargeVector<sim::Manifold>& manifolds = fast ? scratch.fast.found.manifolds : scratch.manifolds;
  for (std::uint32_t t = all.touched_start[layer]; t < all.touched_end[layer]; ++t) {
    if (all.touched[t].body != row_) continue;
    for (std::uint32_t e = all.touched[t].begin; e < all.touched[t].end; ++e) {
      const std::uint32_t entry = all.entries[e], slot = entry / 2;
      const sim::ContactBatch& batch = all.batches[all.layer_start[layer] + slot / sim::kLanes];
      const sim::Manifold& m = manifolds[all.order[batch.members + slot % sim::kLanes]];
      const double* row = scratch.outcomes[entry].of;
      const sim::Vec3 velocity = sim::VelocityGrid::round(sim::Vec3(row[0], row[1], row[2]));
      const sim::Vec3 spin = sim::VelocityGrid::round(sim::Vec3(row[3], row[4], row[5]));
      if (velocity == sim::Vec3::Zero() && spin == sim::Vec3::Zero()) continue;
      ContactPart& part = part_of(other_of(m, row_, ids_));
      if (parting_) {
        part.position += velocity * account_.dt;
        continue;
      }
      part.velocity += velocity;
      part.spin += spin;
    }
  }
}

void AccountObserver::look_at_manifolds(const std::string& phase, const sim::World& world) {
  const sim::Scratch& scratch = world.scratch();
  account_.contacts.clear();
  for (const sim::Manifold& m : scratch.manifolds) {
    if (!of_row(m, row_)) continue;
    ContactFacts& facts = facts_of(other_of(m, row_, ids_));
    const bool first = facts.points == 0;
    facts.found_by = phase;
    facts.points += m.count;
    facts.normal = m.b == row_ ? m.n : sim::Vec3(-m.n);
    facts.friction = m.friction;
    facts.restitution = m.restitution;
    facts.asleep = m.asleep;
    for (const sim::ManifoldPoint& point : sim::points_of(scratch, m)) {
      facts.separation = first && &point == &sim::points_of(scratch, m).front()
                             ? point.separation
                             : std::min(facts.separation, point.separation);
      facts.recalled += point.impulse;
    }
  }
}

void AccountObserver::look_at_weights(const sim::World& world) {
  const sim::Scratch& scratch = world.scratch();
  account_.lent = scratch.solver_mass[row_] - account_.mass;
  for (ContactFacts& facts : account_.contacts) {
    double impulse = 0;
    facts.load = 0;
    for (const sim::Manifold& m : scratch.manifolds) {
      if (!of_row(m, row_) || other_of(m, row_, ids_) != facts.other) continue;
      for (const sim::ManifoldPoint& point : sim::points_of(scratch, m)) {
        facts.load += point.load;
        impulse += point.impulse;
      }
    }
    facts.started = facts.recalled == 0 ? impulse : 0;
  }
}

void AccountObserver::look_at_batches(const sim::Scratch& scratch, const sim::ContactBatches& all,
                                      std::uint32_t substep, bool fast) {
  const LargeVector<sim::Manifold>& manifolds = fast ? scratch.fast.found.manifolds : scratch.manifolds;
  for (const sim::ContactBatch& batch : all.batches) {
    for (unsigned lane = 0; lane < batch.used; ++lane) {
      const sim::Manifold& m = manifolds[all.order[batch.members + lane]];
      if (!of_row(m, row_)) continue;
      ContactFacts& facts = facts_of(other_of(m, row_, ids_));
      if (fast) {
        facts.fast = true;
        facts.found_by = "find_fast_contacts";
        facts.normal = m.b == row_ ? m.n : sim::Vec3(-m.n);
        facts.points = m.count;
        facts.friction = m.friction;
        facts.restitution = m.restitution;
        facts.approach = 0;
      }
      facts.substep = substep;
      facts.split = m.a == row_ ? batch.split_a.of[lane] : batch.split_b.of[lane];
      for (unsigned k = 0; k < m.count; ++k) {
        const sim::PointBatch& point = all.points[batch.first + k];
        facts.approach = std::min(facts.approach, point.approach.of[lane]);
        if (fast)
          facts.separation = k == 0 ? point.separation.of[lane] : std::min(facts.separation, point.separation.of[lane]);
      }
    }
  }
}

void AccountObserver::look_layered(const std::string& phase, std::uint32_t substep, const sim::World& world) {
  const sim::Scratch& scratch = world.scratch();
  if (phase == "find_manifolds") look_at_manifolds(phase, world);
  if (phase == "wake_islands") {
    if (scratch.found_again) look_at_manifolds("find_manifolds", world);
    const auto woke = [&](sim::BodyId id) {
      const auto at = std::ranges::lower_bound(ids_, id) - ids_.begin();
      return frozen_[static_cast<std::size_t>(at)] != world.bodies().frozen[static_cast<std::size_t>(at)];
    };
    for (ContactFacts& facts : account_.contacts) {
      facts.woke = woke(account_.body) || (facts.other && woke(*facts.other));
    }
  }
  if (phase == "assign_levels") {
    for (const sim::Manifold& m : scratch.manifolds) {
      if (!of_row(m, row_) || m.asleep) continue;
      ContactFacts& facts = facts_of(other_of(m, row_, ids_));
      facts.layer = m.layer;
      facts.hard |= in_hard_layer(scratch, m);
      facts.sweeps = sweeps_of(scratch, m);
    }
  }
  if (phase == "carry_weights") look_at_weights(world);
  if (phase == "prepare_manifolds") look_at_batches(scratch, scratch.contact_batches, 0, false);
  if (phase == "find_fast_contacts" && !scratch.fast.none())
    look_at_batches(scratch, scratch.fast.batches, substep, true);
}

}  // namespace tumble::replay
