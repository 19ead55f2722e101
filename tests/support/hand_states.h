#pragma once

#include <cstdint>
#include <vector>

#include "tumble/replay/step_record.h"

/// States and steps written by hand, whose measures are known.
namespace tumble::replay {

using sim::BoxDef;

/// A unit cube of 1 kg at rest.
BoxDef box(sim::BodyId id, const sim::Vec3& position);

/// What a log would hold of them. boxes: ascending ids.
BodyStates states_of(const std::vector<BoxDef>& boxes);

/// Method thesis, ground, gravity −10 m/s².
sim::SceneDef scene_of(const std::vector<BoxDef>& boxes);

/// A step of 0.25 s with these states after it.
StepRecord step_record(std::uint64_t step, const std::vector<BoxDef>& boxes, double kinetic = 0, double potential = 0,
                       double inputs = 0, double removed = 0);

}  // namespace tumble::replay
