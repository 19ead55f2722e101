#pragma once

#include <cstdint>
#include <vector>

#include "golden/hunt/judge/trace.h"

namespace tumble::hunt {

/// Two boxes farther apart than this in the whole of a step do not meet, m. Contacts may act over less.
inline constexpr double kNear = 1e-3;

/// Of the bodies with which step k begins: whether one can meet neither the ground nor another body within the step,
/// whatever the others do. Follows free flights by samples and allows for all that may happen between two of them, so
/// a body that is marked is surely far from all others; one that is not marked may still be.
std::vector<std::uint8_t> surely_unmet(const Trace& trace, std::size_t k);

/// The pairs that may have met in a step, the ground included: all but those that surely stayed apart.
std::vector<Meeting> may_have_met(const Trace& trace, std::size_t k);

}  // namespace tumble::hunt
