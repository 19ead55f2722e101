#pragma once

#include "src/kernels/kernels.h"
#include "src/kernels/lane_width.h"

namespace tumble::sim {

/// Whether this machine and this build run a width; always true of kWidest, kOne and kTwo.
bool runs_lanes(LaneWidth width);

/// The kernels of a width. Precondition: runs_lanes(width).
const Kernels& kernels(LaneWidth width);

}  // namespace tumble::sim
