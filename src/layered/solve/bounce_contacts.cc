#include "src/layered/solve/bounce_contacts.h"

#include <algorithm>

#include "src/layered/find/contact_memory.h"
#include "src/layered/solve/contact_batches.h"
#include "src/layered/solve/solver_hashes.h"
#include "src/layered/solve/sweep_layers.h"
#include "src/world/hash_on_the_way.h"

namespace tumble::sim {
namespace {

// Adds the velocities if a contact may have bounced. Without one no body moves: another velocity is this phase's doing.
void add_bounced(const Scratch& scratch, Hasher& hasher) {
  const auto moved = [&](std::uint32_t visit) { return visit > scratch.visits.first; };
  if (!scratch.contact_batches.impacts.empty() || std::ranges::any_of(scratch.visits.moved, moved)) {
    add_solver_velocities(scratch, hasher);
  }
}

// As store_contacts does for layers, of the last substep.
void keep_borne_of_fast_pairs(Scratch& scratch, double fall) {
  FastContacts& fast = scratch.fast;
  if (fast.none() || !keep_borne_of_fast(scratch, fall)) return;
  remember_contacts(fast.found.manifolds, fast.found.points, nullptr, {}, scratch.workers, fast.memory);
}

}  // namespace

Status bounce_contacts(WorldState& state, Scratch& scratch, double dt_s) {
  Hasher* const hasher = take_hasher(scratch);
  scratch.visits.first = scratch.visits.now;
  bounce_layers(scratch, dt_s);
  if (hasher != nullptr) add_bounced(scratch, *hasher);
  const double fall = length(state.def.gravity) * dt_s / state.def.substeps;
  store_contacts(scratch, hasher, fall);
  keep_borne_of_fast_pairs(scratch, fall);
  if (hasher != nullptr) {
    GatheredNumbers numbers(hasher);
    add_stored_fast_contacts(scratch.fast, numbers);
  }
  return {};
}

void hash_bounce_contacts(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  add_bounced(scratch, hasher);
  GatheredNumbers numbers(&hasher);
  add_stored_contacts(scratch, 0, scratch.layered.size(), numbers);
  add_stored_fast_contacts(scratch.fast, numbers);
}

}  // namespace tumble::sim
