#include "src/thesis/integrate.h"

#include "src/world/body_check.h"
#include "src/world/free_flight.h"

namespace tumble::sim {

Status integrate(WorldState& state, Scratch& scratch, double dt_s) {
  integrate_free(state, scratch.lanes, {0, state.bodies.size()}, nullptr, dt_s);
  return check_moving(state.bodies, scratch.lanes);
}

void hash_integrate(const WorldState& state, const Scratch& /*scratch*/, Hasher& hasher) {
  hash_motion(state.bodies, hasher);
}

}  // namespace tumble::sim
