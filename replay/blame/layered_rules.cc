// Rules of method layered.
#include <algorithm>
#include <cmath>
#include <map>

#include "replay/blame/phase_rules.h"
#include "src/base/text.h"
#include "src/kernels/contacts/contact_batch.h"

namespace tumble::replay {
namespace {

constexpr double kSpeedPart = 1e-5;       // of a value, that rounding explains
constexpr double kSpeedOff = 1e-8;        // m/s
constexpr double kSeparationOff = 1e-12;  // m

sim::Vec3 lane_vector(const sim::Lanes* lanes, unsigned lane) {
  return {lanes[0].of[lane], lanes[1].of[lane], lanes[2].of[lane]};
}

// Calls visit(batch, lane, manifold) for each awake contact of the body in the batches.
template <class Visit>
void for_each_lane(const sim::ContactBatches& all, const LargeVector<sim::Manifold>& manifolds, sim::BodyIndex row,
                   Visit visit) {
  for (const sim::ContactBatch& batch : all.batches) {
    for (unsigned lane = 0; lane < batch.used; ++lane) {
      const sim::Manifold& m = manifolds[all.order[batch.members + lane]];
      if (m.a == row || m.b == row) visit(batch, lane, m);
    }
  }
}

// The change of the body's velocity by the impulses that a contact has.
sim::Vec3 gain_by_impulses(const sim::ContactBatches& all, const sim::ContactBatch& batch, unsigned lane, double sign,
                           const sim::SolverBody& body) {
  double pressure = 0;
  for (unsigned k = 0; k < batch.count; ++k) pressure += all.points[batch.first + k].impulse.of[lane];
  const sim::Vec3 force =
      sign * (lane_vector(batch.n, lane) * pressure + lane_vector(batch.t1, lane) * batch.force1.of[lane] +
              lane_vector(batch.t2, lane) * batch.force2.of[lane]);
  return force * body.inverse_mass - body.lent * sim::dot(body.lent, force);
}

}  // namespace

// A substep begins with the impulses of the one before (warm starting).
void PhaseRules::carries_impulses(std::uint32_t substep, const sim::World& world,
                                  const std::vector<ContactPart>& parts) {
  const sim::Scratch& scratch = world.scratch();
  if (row_ >= scratch.in_contact.size() || scratch.in_contact[row_] == 0) return;
  std::map<Other, sim::Vec3> wanted;
  const auto add_up = [&](const sim::ContactBatches& all, const LargeVector<sim::Manifold>& manifolds) {
    for_each_lane(all, manifolds, row_, [&](const sim::ContactBatch& batch, unsigned lane, const sim::Manifold& m) {
      const Other other = id_of(m.a == row_ ? m.b : m.a);
      const sim::Vec3 gain = gain_by_impulses(all, batch, lane, m.b == row_ ? 1 : -1, scratch.solver_bodies[row_]);
      const auto [at, fresh] = wanted.try_emplace(other, gain);
      if (!fresh) at->second += gain;
    });
  };
  add_up(scratch.contact_batches, scratch.manifolds);
  if (!scratch.fast.none()) add_up(scratch.fast.batches, scratch.fast.found.manifolds);
  for (const auto& [other, gain] : wanted) {
    const auto part = std::ranges::find(parts, other, &ContactPart::other);
    const sim::Vec3 given = part == parts.end() ? sim::Vec3(sim::Vec3::Zero()) : part->velocity;
    const double size = gain.norm(), off = (gain - given).norm();
    if (!(off > kSpeedPart * size + kSpeedOff)) continue;
    add({.substep = substep,
         .phase = "apply_forces",
         .body = ids_[row_],
         .other = other,
         .value = "carried impulse",
         .unit = "m/s",
         .wanted = size,
         .found = given.norm(),
         .text = "carries an impulse worth " + rounded(size, "m/s") + " into this substep, but the body got " +
                 rounded(given.norm(), "m/s") + " from it"});
  }
}

void PhaseRules::note_points(const sim::World& world) {
  const sim::Scratch& scratch = world.scratch();
  points_.clear();
  for_each_lane(scratch.contact_batches, scratch.manifolds, row_,
                [&](const sim::ContactBatch& batch, unsigned lane, const sim::Manifold& /*m*/) {
                  for (unsigned k = 0; k < batch.count; ++k) {
                    const sim::PointBatch& point = scratch.contact_batches.points[batch.first + k];
                    points_.push_back(
                        {point.separation.of[lane], point.p.of[lane], point.q.of[lane], lane_vector(batch.d, lane)});
                  }
                });
}

// The separation of a point changes by the way that the bodies go at the point, by the velocities with which they were
// moved. Fast pairs may wait and are left out.
void PhaseRules::moves_separations(std::uint32_t substep, const sim::World& world) {
  const sim::Scratch& scratch = world.scratch();
  const sim::ContactBatches& all = scratch.contact_batches;
  const double substep_s = world.state().def.dt / world.state().def.substeps;
  std::size_t at = 0;
  for_each_lane(
      all, scratch.manifolds, row_, [&](const sim::ContactBatch& batch, unsigned lane, const sim::Manifold& m) {
        const sim::BatchSides& sides = all.sides[static_cast<std::size_t>(&batch - all.batches.data())];
        const sim::SolverBody &a = scratch.solver_bodies[sides.a[lane]], &b = scratch.solver_bodies[sides.b[lane]];
        const sim::Vec3 spin = b.spin - a.spin;
        const double w1 = sim::dot(spin, lane_vector(batch.t1, lane)), w2 = sim::dot(spin, lane_vector(batch.t2, lane));
        for (unsigned k = 0; k < batch.count && at < points_.size(); ++k, ++at) {
          if (k >= m.count) continue;
          const PointBefore& before = points_[at];
          const sim::Vec3 motion = (b.velocity - a.velocity) - sim::cross(a.spin, before.d);
          const double way =
              substep_s * (sim::dot(motion, lane_vector(batch.n, lane)) + (w1 * before.q - w2 * before.p));
          const double now = all.points[batch.first + k].separation.of[lane], moved = now - before.separation;
          if (!(std::fabs(moved - way) > kSpeedPart * std::fabs(way) + kSeparationOff)) continue;
          add({.substep = substep,
               .phase = "integrate_positions",
               .body = ids_[row_],
               .other = id_of(m.a == row_ ? m.b : m.a),
               .value = "separation",
               .unit = "m",
               .wanted = before.separation + way,
               .found = now,
               .text = "a point moved by " + rounded(way, "m") + " along the normal, but its separation changed by " +
                       rounded(moved, "m")});
        }
      });
}

void PhaseRules::look_layered(std::uint32_t substep, const std::string& phase, const sim::World& world,
                              const std::vector<ContactPart>& parts) {
  if (phase == "apply_forces") carries_impulses(substep, world, parts);
  if (phase == "push_contacts") note_points(world);
  if (phase == "integrate_positions") moves_separations(substep, world);
}

}  // namespace tumble::replay
