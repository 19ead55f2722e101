#pragma once

#include <vector>

#include "src/layered/solve/contact_batches.h"
#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Lists the bodies of fast pairs with their state, and gives those that move to the solver (in_contact). Takes the
/// contact memory of the last step for that of the substep before.
void list_fast_bodies(const WorldState& state, Scratch& scratch);

/// Marks the bodies that a contact of a fast pair has pressed in this substep.
void mark_pressed(Scratch& scratch);

/// Tells which bodies fly in this substep, since no contact presses them; and which wait for the rest of it where they
/// met, so that they bounce as they were turned when they were hit. What is driven on by a body that goes on does not.
void find_flying(const Bodies& bodies, Scratch& scratch, double substep_s);

/// Where what parts is pressed anew, since something else drives a body back into it, that gives the bodies energy as
/// the push is ended: lets what bounces off these bodies give back so much less. Needs what impacts have taken.
void take_back_gifts(const Bodies& bodies, Scratch& scratch);

/// Bodies, pairs or contacts of fast pairs that a part must have for a split to pay.
inline constexpr std::size_t kFastAPart = 128;

/// Calls visit(body) for all bodies of fast pairs, by several workers at a time.
template <class Visit>
void for_fast_bodies(Scratch& scratch, Visit visit) {
  std::vector<FastBody>& bodies = scratch.fast.bodies;
  for_ranges(scratch.workers, bodies.size(), kFastAPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) visit(bodies[k]);
  });
}

/// Calls visit(work, begin, end) for the batches [begin, end) of the contacts of fast pairs, by several workers at a
/// time.
template <class Visit>
void for_fast_batches(Scratch& scratch, double substep_s, Visit visit) {
  const ContactWork work = fast_contacts(scratch, substep_s);
  for_ranges(scratch.workers, work.count, kFastAPart / kLanes,
             [&](std::size_t begin, std::size_t end) { visit(part_of(work, begin, end), begin, end); });
}

/// The body if the solver moves it for contacts of fast pairs alone, else null.
inline const FastBody* fast_body(const Scratch& scratch, std::size_t i) {
  if (scratch.fast.none() || scratch.in_contact[i] != kInFastPair) return nullptr;
  return &scratch.fast.bodies[scratch.fast.place[i]];
}

/// Takes the bodies that nothing has pressed out of the solver, with the state that they had at the start of the step:
/// what only passes flies as if alone.
void release_untouched(WorldState& state, Scratch& scratch);

}  // namespace tumble::sim
