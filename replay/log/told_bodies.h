#pragma once

#include <span>
#include <vector>

#include "tumble/replay/extras.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world.h"

namespace tumble::replay {

/// Checks that the values and contacts of a step, or of the start, are of bodies that exist: of those that the step
/// has, and of those that its inputs removed. The second body of a pair's value may be one that the log does not tell
/// of, and that of a contact 0. Errors (kBadInput) name the body.
Status check_bodies(const Extras& extras, const std::vector<Channel>& channels, const sim::Bodies& bodies,
                    std::span<const sim::Command> inputs);

/// Errors (kBadInput): a finite orientation that is no rotation, which would be measured and drawn wrongly: its length
/// is further than off_max from 1.
Status check_rotation(sim::BodyId id, const sim::Quat& q, double off_max);

}  // namespace tumble::replay
