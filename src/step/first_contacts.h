#pragma once

#include <optional>

#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Finds the supports of bodies that start frozen, as if they had come to rest there. Method thesis gets contact
/// objects (the lowest objects that touch, thesis III.D); method layered gets remembered contacts, so that the bodies
/// sleep and wake as islands. Bodies within a millimetre touch; a contact at an edge or a corner alone does not carry.
/// A body that touches nothing stays frozen until it is hit. body: the one that was thrown in frozen; nullopt: all
/// frozen bodies of a new world.
void find_first_contacts(WorldState& state, std::optional<BodyIndex> body);

/// Method layered: wakes what body i, just thrown in, touches or overlaps, and all that contacts connect with that; of
/// those that are awake the time of rest starts anew. A step would wake them for a lively body alone: nothing tells a
/// sleeper of a static box that is put into it, or of one that is laid on it.
void wake_touched(WorldState& state, BodyIndex i);

}  // namespace tumble::sim
