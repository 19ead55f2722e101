#include "src/solve/prepare_manifolds.h"

#include "src/solve/contact_batches.h"
#include "src/solve/solver_body.h"

namespace tumble::sim {
namespace {

void prepare_bodies(World& world) {
  const Bodies& bodies = world.bodies();
  Scratch& scratch = world.mutable_scratch();
  const std::size_t n = bodies.size();
  scratch.solver_bodies.assign(n + 1, {});
  scratch.solver_sums.assign(n + 1, {});
  for (BodyIndex i = 0; i < n; ++i) {
    SolverBody& body = scratch.solver_bodies[i];
    if (bodies.moves(i)) {
      body.velocity = bodies.velocity[i];
      body.spin = bodies.spin[i];
      const double mass = scratch.solver_mass[i];
      const bool lent = mass != bodies.mass[i];
      body.weight = bodies.mass[i] / mass;
      body.inverse_mass = lent ? 1 / mass : bodies.inverse_mass[i];
      set_inverse_inertia(body, scratch.frames[i].axes, bodies.inverse_inertia[i] * body.weight);
    }
    scratch.solver_sums[i].velocity = body.velocity;
    scratch.solver_sums[i].spin = body.spin;
  }
}

void find_in_contact(World& world) {
  const Bodies& bodies = world.bodies();
  Scratch& scratch = world.mutable_scratch();
  scratch.in_contact.assign(bodies.size(), 0);
  for (const std::uint32_t k : scratch.layered) {
    const Manifold& m = scratch.manifolds[k];
    if (m.a != kGround && bodies.moves(m.a)) scratch.in_contact[m.a] = 1;
    if (bodies.moves(m.b)) scratch.in_contact[m.b] = 1;
  }
}

}  // namespace

Status prepare_manifolds(World& world, double dt_s) {
  prepare_bodies(world);
  find_in_contact(world);
  batch_contacts(world);
  Scratch& scratch = world.mutable_scratch();
  contact_kernels(scratch.lanes).prepare(all_contacts(scratch, dt_s));
  mark_bounces(scratch.contact_batches);
  return {};
}

void hash_prepare_manifolds(const World& world, Hasher& hasher) {
  const Scratch& scratch = world.scratch();
  const ContactBatches& all = scratch.contact_batches;
  for (std::size_t k = 0; k < scratch.manifolds.size(); ++k) {
    if (scratch.manifolds[k].asleep) continue;
    const ContactBatch& batch = all.batches[all.place[k] / kLanes];
    const unsigned lane = all.place[k] % kLanes;
    for (const Lanes* lanes : {&batch.centre_p, &batch.centre_q, &batch.radius, &batch.relaxation}) {
      hasher.add(lanes->of[lane]);
    }
    for (const Lanes& lanes : batch.friction_inverse) hasher.add(lanes.of[lane]);
    for (const Lanes& lanes : batch.response) hasher.add(lanes.of[lane]);
    for (std::uint32_t i = batch.first; i < batch.first + scratch.manifolds[k].count; ++i) {
      hasher.add(all.points[i].mass.of[lane]);
      hasher.add(all.points[i].approach.of[lane]);
    }
  }
}

}  // namespace tumble::sim
