#pragma once

#include <optional>

#include "src/world/world_state.h"

namespace tumble::sim {

/// Gives bodies that start frozen what they rest upon, as if they had come to rest there: contact objects with method
/// thesis (the lowest things that touch, thesis III.D), remembered contacts with layered (so that they sleep and wake
/// as islands). Touching is within a millimetre; meeting only at an edge or a corner does not carry. A body that
/// touches nothing stays frozen until it is hit. body: one that was thrown in frozen; without it, all frozen bodies of
/// a new world.
void find_first_contacts(WorldState& state, std::optional<BodyIndex> body);

}  // namespace tumble::sim
