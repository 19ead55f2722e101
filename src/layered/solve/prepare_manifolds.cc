#include "src/layered/solve/prepare_manifolds.h"

#include <algorithm>

#include "src/kernels/kernels_by_width.h"
#include "src/layered/batch/batch_contacts.h"
#include "src/layered/batch/layer_reach.h"
#include "src/layered/batch/share_sweeps.h"
#include "src/layered/order/solver_body.h"
#include "src/layered/order/update_sleeping.h"
#include "src/layered/solve/contact_batches.h"
#include "src/layered/solve/fast_bodies.h"
#include "src/layered/solve/solver_hashes.h"
#include "src/layered/solve/sweep_layers.h"
#include "src/world/for_bodies.h"
#include "src/world/hash_on_the_way.h"

namespace tumble::sim {
namespace {

SolverBody solver_body(const Bodies& bodies, const Scratch& scratch, BodyIndex i) {
  SolverBody body;
  if (!bodies.moves(i)) return body;
  body.velocity = bodies.velocity[i];
  body.spin = bodies.spin[i];
  body.inverse_mass = bodies.inverse_mass[i];
  set_inertia(body, bodies, scratch, i, scratch.frames[i].axes);
  const double mass = scratch.solver_mass[i];
  if (mass != bodies.mass[i]) keep_momentum(body, bodies.mass[i] / mass, scratch.lent_along[i]);
  return body;
}

// Needs in_contact where the bodies are hashed.
void prepare_bodies(WorldState& state, Scratch& scratch, Hasher* hasher) {
  const Bodies& bodies = state.bodies;
  const std::size_t n = bodies.size();
  scratch.solver_bodies.resize(n + 1);
  scratch.solver_bodies[n] = {};
  std::vector<std::uint32_t>& moved = scratch.visits.moved;
  moved.reserve(n + 1);
  fill_bodies(scratch, n, moved, 0U);
  moved.push_back(0);  // of the ground
  const auto prepare = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      scratch.solver_bodies[i] = solver_body(bodies, scratch, static_cast<BodyIndex>(i));
    }
  };
  GatheredNumbers numbers(hasher);
  for_hashed_bodies(hasher, scratch, n, kBodiesABlock, prepare,
                    [&](std::size_t begin, std::size_t end) { add_solver_bodies(scratch, begin, end, numbers); });
}

void find_in_contact(WorldState& state, Scratch& scratch) {
  const Bodies& bodies = state.bodies;
  scratch.in_contact.resize(bodies.size());
  for_bodies(scratch, bodies.size(), [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) {
      scratch.in_contact[i] =
          bodies.moves(i) && scratch.graph.start[i] < scratch.graph.start[i + 1] ? kInContact : kFree;
    }
  });
}

// Which bodies are in contact, and which manifold is where.
void add_places(const Scratch& scratch, Hasher& hasher) {
  hasher.add(std::span<const std::uint8_t>(scratch.in_contact));
  hasher.add(std::span<const std::uint32_t>(scratch.contact_batches.order));
}

}  // namespace

Status prepare_manifolds(WorldState& state, Scratch& scratch, double dt_s) {
  scratch.visits.now = 0;
  scratch.visits.still = kStillPart * length(state.def.gravity) * dt_s;
  Hasher* const hasher = take_hasher(scratch);
  find_in_contact(state, scratch);
  note_energies(state, scratch, dt_s);
  list_fast_bodies(state, scratch);
  prepare_bodies(state, scratch, hasher);
  batch_contacts(state, scratch);
  find_layer_reach(scratch);
  share_sweeps(state, scratch);
  if (hasher != nullptr) add_places(scratch, *hasher);
  ContactWork work = all_contacts(scratch, dt_s);
  work.turn_s = 0.5 * state.def.dt / state.def.substeps;  // to the middle of the first substep
  std::uint8_t any_met = 0;
  const auto prepare = [&](std::size_t begin, std::size_t end) {
    for (; begin < end; begin += kBatchesABlock) {
      const ContactWork block = part_of(work, begin, std::min(begin + kBatchesABlock, end));
      kernels(scratch.lanes).contacts.prepare(block);
      if (mark_bounces(block)) mark(any_met);  // while the block is in the nearest cache
    }
  };
  for_hashed_batches(hasher, scratch, prepare, [&](std::size_t begin, std::size_t end) {
    add_batches(scratch.contact_batches, begin, end, *hasher);
  });
  list_impacts(scratch.contact_batches, any_met != 0);
  return {};
}

void hash_prepare_manifolds(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  GatheredNumbers numbers(&hasher);
  add_solver_bodies(scratch, 0, scratch.in_contact.size(), numbers);
  numbers.pass_on();
  add_places(scratch, hasher);
  add_batches(scratch.contact_batches, 0, scratch.contact_batches.batches.size(), hasher);
}

}  // namespace tumble::sim
