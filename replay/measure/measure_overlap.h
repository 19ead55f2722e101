#pragma once

#include <cstdint>
#include <span>

#include "src/kernels/box_frame.h"

namespace tumble::replay {

/// The largest separation of two boxes along any of the fifteen axes, m: at most their distance where it is positive;
/// the depth to which they overlap, negative, where it is not.
double separation_of(const sim::BoxFrame& a, const sim::BoxFrame& b);

/// The depth to which two boxes overlap, m: the shortest way to push them apart along one of the fifteen separating
/// axes; 0 when they are apart or touch. Shares no code with the solver's pair test, whose faults it must be able to
/// see. Source: Gottschalk, Lin, Manocha, "OBBTree", 1996, section 5.
double overlap_depth(const sim::BoxFrame& a, const sim::BoxFrame& b);

/// The deepest overlap of any two boxes, m; 0 if none; NaN where a box has no finite extent. boxes and left_out have
/// one entry a body; a pair with both boxes left out (static, not chosen) does not count. A settled heap of thousands
/// takes milliseconds.
double deepest_overlap(std::span<const sim::BoxFrame> boxes, std::span<const std::uint8_t> left_out);

/// The depth of the lowest corner under z = 0, m; 0 above.
double ground_penetration(const sim::BoxFrame& box);

}  // namespace tumble::replay
