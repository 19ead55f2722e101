#include "src/layered/solve/integrate_positions.h"

#include "src/kernels/kernels_by_width.h"
#include "src/layered/order/solver_body.h"
#include "src/layered/solve/contact_batches.h"
#include "src/layered/solve/solver_hashes.h"
#include "src/layered/solve/sweep_layers.h"
#include "src/math/grid.h"
#include "src/world/body_check.h"
#include "src/world/free_flight.h"

namespace tumble::sim {
namespace {

constexpr double kStiff = 0.002;  // rad in a substep; below, the inverse inertia is not computed anew

// Turns a body as in free flight, which keeps angular momentum and energy. With a constant spin in world axes instead,
// a fast bar would gain both.
void turn(Bodies& bodies, Scratch& scratch, BodyIndex i, double substep_s) {
  SolverBody& body = scratch.solver_bodies[i];
  const Vec3 inertia = bodies.inertia[i], inverse = bodies.inverse_inertia[i];
  const Rotation rotation = rotate_freely(bodies.orientation[i], body.spin, inertia, inverse, substep_s);
  bodies.orientation.set(i, rotation.orientation);
  const double turned_squared = dot(body.spin, body.spin) * (substep_s * substep_s);
  if (inertia.x() == inertia.y() && inertia.y() == inertia.z()) return;
  body.spin = rotation.spin;
  if (turned_squared > kStiff * kStiff) {
    set_inverse_inertia(body, axes_of(rotation.orientation), inverse * body.weight);
  }
}

void move_body(Bodies& bodies, Scratch& scratch, BodyIndex i, double substep_s) {
  const Vec3 path = PositionGrid::round(Vec3(scratch.solver_bodies[i].velocity * substep_s));
  bodies.position.set(i, plus_zero(bodies.position[i] + path));
  turn(bodies, scratch, i, substep_s);
}

}  // namespace

Status integrate_positions(WorldState& state, Scratch& scratch, double substep_s) {
  Bodies& bodies = state.bodies;
  for_ranges(scratch.workers, bodies.size(), kBodiesAPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (scratch.in_contact[i] != 0) move_body(bodies, scratch, static_cast<BodyIndex>(i), substep_s);
    }
  });
  // A bar is thousands of times as easy to turn about its length as across it. After a turn by a degree the right
  // impulse is several times smaller, and sweeps with the old response would diverge.
  const bool renews = has_slender(scratch);
  const ContactWork work = all_contacts(scratch, substep_s);
  for_ranges(scratch.workers, work.count, kBatchesAPart, [&](std::size_t begin, std::size_t end) {
    kernels(scratch.lanes).contacts.move_on(part_of(work, begin, end));
    if (renews) kernels(scratch.lanes).contacts.renew(part_of(work, begin, end));
  });
  return {};
}

void hash_integrate_positions(const WorldState& state, const Scratch& scratch, Hasher& hasher) {
  hash_places(state.bodies, hasher);
  hash_moved(state.bodies, scratch, hasher);
  if (has_slender(scratch)) hash_prepared(scratch, hasher);
}

}  // namespace tumble::sim
