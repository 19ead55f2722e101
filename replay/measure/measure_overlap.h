#pragma once

#include <cstdint>
#include <span>

#include "src/kernels/box_frame.h"

namespace tumble::replay {

/// How deep two boxes overlap, m: the shortest way to push them apart along one of the fifteen separating axes; 0 when
/// they are apart or touch. Written anew, without the solver's own pair test and its rules of which axis may count:
/// what judges the physics shares no code with it.
/// Source: Gottschalk, Lin, Manocha, "OBBTree", 1996, section 5.
double overlap_depth(const sim::BoxFrame& a, const sim::BoxFrame& b);

/// The deepest overlap of any two boxes, m; 0 if none. Pairs of which neither box is of interest (static, not chosen)
/// do not count. boxes and left_out have one entry a body. Sorts along the axis on which the centres spread most, so a
/// settled heap of thousands takes milliseconds.
double deepest_overlap(std::span<const sim::BoxFrame> boxes, std::span<const std::uint8_t> left_out);

/// How deep the lowest corner lies under z = 0, m; 0 if it does not.
double ground_penetration(const sim::BoxFrame& box);

}  // namespace tumble::replay
