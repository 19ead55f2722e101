#include "src/layered/solve/bounce_fast_contacts.h"

#include "src/layered/find/contact_memory.h"
#include "src/layered/solve/contact_batches.h"
#include "src/layered/solve/fast_bodies.h"
#include "src/layered/solve/solver_hashes.h"
#include "src/layered/solve/sweep_layers.h"
#include "src/world/hash_on_the_way.h"

namespace tumble::sim {
namespace {

// Bodies that bounce have waited where they met, though their velocities moved the separations on.
void put_back(Scratch& scratch) {
  LargeVector<PointBatch>& points = scratch.fast.batches.points;
  for_ranges(scratch.workers, points.size(), kFastAPart / kLanes, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      for (int lane = 0; lane < kLanes; ++lane) {
        if (points[k].approach.of[lane] <= -kFastBounceMin) points[k].separation.of[lane] = 0;
      }
    }
  });
}

}  // namespace

Status bounce_fast_contacts(WorldState& state, Scratch& scratch, double substep_s) {
  scratch.visits.bounces = scratch.visits.now;
  if (scratch.fast.none()) return {};
  put_back(scratch);
  scratch.fast.takes_along = bounce_fast_layer(state.bodies, scratch, substep_s);
  mark_pressed(scratch);
  store_fast_contacts(scratch);
  const ManifoldList& found = scratch.fast.found;
  remember_contacts(found.manifolds, found.points, nullptr, {}, scratch.workers, scratch.fast.memory);
  scratch.fast.remembers = true;
  return {};
}

void hash_bounce_fast_contacts(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  if (scratch.fast.none()) return;
  if (scratch.fast.takes_along) return hash_solution(scratch, hasher);
  {
    GatheredNumbers numbers(&hasher);
    for (const FastBody& of : scratch.fast.bodies) {
      const SolverBody& body = scratch.solver_bodies[of.row];
      numbers.add(body.velocity);
      numbers.add(body.spin);
    }
  }
  add_fast_batches(scratch, hasher);
}

}  // namespace tumble::sim
