#pragma once

#include <vector>

#include "tumble/sim/world_state.h"

/// Contact memory of method layered after an input that changes what contacts have to carry. A remembered impulse that
/// nothing asks for any more would throw the bodies apart: a sweep takes it from the contacts at the ends of a stack
/// first, and few sweeps do not reach its middle. A contact without an impulse starts from its load (carry_weights).
namespace tumble::sim {

/// Forgets every impulse and keeps the contacts. For inputs that change gravity or dt.
void forget_impulses(ContactMemory& memory);

/// All bodies that remembered contacts connect with body i, without i, ascending. A static body connects nothing,
/// unless it is i.
std::vector<BodyIndex> connected_with(const WorldState& state, BodyIndex i);

/// Forgets the contacts of body i, and the impulses of all bodies that contacts connect with it (a static body connects
/// nothing else). Returns those bodies, without i, ascending. For an input that removes body i.
std::vector<BodyIndex> forget_contacts(WorldState& state, BodyIndex i);

}  // namespace tumble::sim
