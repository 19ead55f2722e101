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

}  // namespace tumble::sim
