#pragma once

#include <cstdint>
#include <span>

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// For each body whether its island is *hard*, so that its contacts are swept more often; empty if none is. An island
/// is hard if it has a slender body (a bar), two bodies that touch, of which one moves and one is at least 16 times as
/// heavy as the other, or a plate that may be driven into what it hits. Bodies at rest connect nothing.
std::span<const std::uint8_t> find_hard_islands(const WorldState& state, Scratch& scratch, double dt_s);

}  // namespace tumble::sim
