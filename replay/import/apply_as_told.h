#pragma once

#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"
#include "tumble/sim/world.h"

namespace tumble::replay {

/// Applies an input of another engine to the bodies that wait for their states of the step. The engine decides what
/// sleeps: neither a change of gravity nor a body that is added wakes another. What a push or a velocity does that our
/// world refuses, of a static body or past the speeds of a world, the states tell. Errors (kBadInput): as sim::apply().
Status apply_as_told(sim::World& world, const sim::Command& command);

}  // namespace tumble::replay
