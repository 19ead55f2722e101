#include "src/layered/solve/finish_motion.h"

#include "src/kernels/kernels_by_width.h"
#include "src/layered/find/contact_memory.h"
#include "src/layered/solve/fast_bodies.h"
#include "src/math/grid.h"
#include "src/world/body_check.h"
#include "src/world/body_columns.h"
#include "src/world/for_bodies.h"
#include "src/world/free_flight.h"
#include "src/world/hash_on_the_way.h"

namespace tumble::sim {
namespace {

void leave_contact(WorldState& state, Scratch& scratch, BodyIndex i, double dt_s) {
  Bodies& bodies = state.bodies;
  const SolverBody& body = scratch.solver_bodies[i];
  const double slower = 1 + state.def.air_drag * dt_s;
  bodies.velocity.set(i, plus_zero(slower > 1 ? VelocityGrid::round(Vec3(body.velocity / slower)) : body.velocity));
  bodies.spin.set(i, plus_zero(slower > 1 ? VelocityGrid::round(Vec3(body.spin / slower)) : body.spin));
}

// Adds the contacts of fast pairs, as the last substep left them, to those that the step found.
void add_fast_contacts(Scratch& scratch) {
  FastContacts& fast = scratch.fast;
  if (fast.none()) return;
  const std::size_t manifolds = scratch.manifolds.size(), layered = scratch.layered.size();
  const auto points = static_cast<std::uint32_t>(scratch.manifold_points.size());
  scratch.manifolds.resize(manifolds + fast.found.manifolds.size());
  scratch.layered.resize(layered + fast.found.manifolds.size());
  scratch.manifold_points.resize(points + fast.found.points.size());
  const std::size_t n = fast.found.manifolds.size();
  for_ranges(scratch.workers, n, kManifoldsAPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      scratch.layered[layered + k] = static_cast<std::uint32_t>(manifolds + k);
      Manifold& m = scratch.manifolds[manifolds + k];
      m = fast.found.manifolds[k];
      for (std::uint32_t at = m.first; at < m.first + m.count; ++at) {
        scratch.manifold_points[points + at] = fast.found.points[at];
      }
      m.first += points;
    }
  });
}

// As check_moving, by several workers at a time.
Status check_bodies(WorldState& state, Scratch& scratch) {
  std::uint8_t any_beyond = 0;
  const BodyColumns bodies = columns_of(state.bodies);
  for_bodies(scratch, state.bodies.size(), [&](std::size_t begin, std::size_t end) {
    if (!kernels(scratch.lanes).bodies.check(bodies, {begin, end})) mark(any_beyond);
  });
  return any_beyond == 0 ? Status() : check_moving(state.bodies, scratch.lanes);
}

void add_memory(const ContactMemory& memory, Hasher& hasher) {
  for (const auto* column : {&memory.a, &memory.b, &memory.count, &memory.feature}) {
    hasher.add(std::span<const std::uint32_t>(*column));
  }
  for (const auto* column :
       {&memory.friction.x, &memory.friction.y, &memory.friction.z, &memory.twist, &memory.impulse}) {
    hasher.add(std::span<const double>(*column));
  }
}

}  // namespace

Status finish_motion(WorldState& state, Scratch& scratch, double dt_s) {
  Hasher* const hasher = take_hasher(scratch);
  release_untouched(state, scratch);
  const Bodies& bodies = state.bodies;
  const auto finish = [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) {
      if (scratch.in_contact[i] != 0) leave_contact(state, scratch, i, dt_s);
    }
    integrate_free(state, scratch.lanes, {begin, end}, scratch.in_contact.data(), dt_s);
  };
  for_hashed_bodies(hasher, scratch, bodies.size(), kMotionsABlock, finish,
                    [&](std::size_t begin, std::size_t end) { add_motion(bodies, begin, end, *hasher); });
  if (Status ok = check_bodies(state, scratch); !ok.ok()) return ok;
  remember_contacts(scratch.manifolds, scratch.manifold_points, scratch.fast.none() ? nullptr : &scratch.fast.memory,
                    scratch.manifold_homes, scratch.workers, state.contact_memory);
  add_fast_contacts(scratch);
  if (hasher != nullptr) add_memory(state.contact_memory, *hasher);
  return {};
}

void hash_finish_motion(const WorldState& state, const Scratch& /*scratch*/, Hasher& hasher) {
  hash_motion(state.bodies, hasher);
  add_memory(state.contact_memory, hasher);
}

}  // namespace tumble::sim
