#include "src/layered/solve/find_fast_contacts.h"

#include <algorithm>

#include "src/kernels/kernels_by_width.h"
#include "src/layered/find/build_manifolds.h"
#include "src/layered/order/batch_contacts.h"
#include "src/layered/order/solver_body.h"
#include "src/layered/solve/contact_batches.h"
#include "src/layered/solve/solver_hashes.h"

namespace tumble::sim {
namespace {

// Frames and velocities as they are in this substep, of all bodies of fast pairs.
void renew_bodies(WorldState& state, Scratch& scratch, double substep_s) {
  Bodies& bodies = state.bodies;
  for (const FastBody& body : scratch.fast.bodies) {
    const BodyIndex i = body.row;
    if (scratch.in_contact[i] == 0) continue;
    const SolverBody& now = scratch.solver_bodies[i];
    bodies.velocity.set(i, plus_zero(now.velocity));
    bodies.spin.set(i, plus_zero(now.spin));
    BoxFrame& frame = scratch.frames[i];
    frame.position = bodies.position[i];
    frame.axes = axes_of(bodies.orientation[i]);
    scratch.turning[i] = length(now.spin) * length(frame.half_extent) * substep_s;
  }
}

bool any_slender(const Bodies& bodies, const FastContacts& fast) {
  return std::ranges::any_of(fast.bodies, [&](const FastBody& body) {
    return bodies.moves(body.row) && is_slender(bodies.inertia[body.row]);
  });
}

}  // namespace

Status find_fast_contacts(WorldState& state, Scratch& scratch, double substep_s) {
  if (scratch.fast.none()) return {};
  renew_bodies(state, scratch, substep_s);
  build_fast_manifolds(state, scratch, substep_s, scratch.fast.found);
  batch_fast_contacts(state, scratch, any_slender(state.bodies, scratch.fast));
  const ContactWork work = fast_contacts(scratch, substep_s);
  kernels(scratch.lanes).contacts.prepare(work);
  mark_bounces(work);
  return {};
}

void hash_find_fast_contacts(const WorldState& state, const Scratch& scratch, Hasher& hasher) {
  if (scratch.fast.none()) return;
  for (const FastBody& body : scratch.fast.bodies) {
    for (const Vec3& v : {state.bodies.velocity[body.row], state.bodies.spin[body.row]}) {
      hasher.add({v.x(), v.y(), v.z()});
    }
  }
  hash_batches(scratch.fast.batches, hasher);
}

}  // namespace tumble::sim
