#pragma once

#include <span>
#include <string>
#include <vector>

#include "tumble/sim/scene.h"
#include "tumble/sim/world_state.h"

namespace tumble::replay {

/// Sentences about a start that is hardly meant: two bodies in one place or deep in one another, a body deep in the
/// ground, a frozen body in mid-air; a step so long that gravity alone moves the smallest body too far for its size;
/// and, in method thesis, a body that moves by more than its shortest edge in a step and may pass through others. The
/// last two look at bodies, velocities, dt and gravity of the start and of `inputs`, which are in the order of their
/// steps. Empty for a start without any. Of ten million pairs and more that are near along x, as a grid of a million
/// bodies has, only the first ten million are looked at.
std::vector<std::string> start_warnings(const sim::WorldState& start, std::span<const sim::TimedCommand> inputs);

}  // namespace tumble::replay
