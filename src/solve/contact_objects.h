#pragma once

#include <vector>

#include "src/world/world.h"

namespace tumble::sim {

/// The contact objects of all candidates that are ready (thesis III.D): for each, those among the things it touches in
/// `contacts` that may carry it and lie lowest, ties included. Only lower bodies carry, and static ones that press from
/// below wherever their centre is: a ramp's may be high. Ascending and unique. The candidates' `lowest` must be
/// +infinity on entry.
ContactObjects collect_contact_objects(const World& world, const Contacts& contacts,
                                       std::vector<FreezeCandidate>& candidates);

}  // namespace tumble::sim
