#pragma once

#include <vector>

#include "src/layered/find/free_path.h"
#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Whether a contact pressed one of the bodies at the end of the last step. hi may be kGround.
bool holds_one(const Scratch& scratch, BodyIndex lo, BodyIndex hi);

/// Whether the contacts of a pair must be found along its free paths: corners leave their tangents by more than the
/// slop or, where contacts hold bodies, by more than the slack. A free body that passes one in contact is followed from
/// the slop on too. hi may be kGround.
bool must_be_followed(const Scratch& scratch, const FreePaths& paths, BodyIndex lo, BodyIndex hi);

/// Whether a pair of which a body is free passes in the step, as both fly now: its contacts, if it meets after all, are
/// found in the substeps.
bool passes(const Scratch& scratch, const FreePaths& paths, BodyIndex lo, BodyIndex hi);

/// Whether a pair that no contact holds may meet fast enough to bounce or, without restitution, to be stopped as by a
/// hit: friction of a hit needs its contacts in the substep of the meeting. hi may be kGround.
bool meets_fast(const WorldState& state, const Scratch& scratch, BodyIndex lo, BodyIndex hi, double dt_s);

/// Whether two bodies, neither of them the ground, may meet if a third stops or hits one of them, or since gravity adds
/// more than half a thickness to their ways (fall, m): such a pair is looked at again in every substep.
bool may_meet_if_hit(const Scratch& scratch, BodyIndex lo, BodyIndex hi, double fall, double dt_s);

/// How the fast pairs approach within a substep, in their order, from velocities and frames as they are.
void find_approaches(const WorldState& state, Scratch& scratch, double substep_s, std::vector<Approach>& out);

}  // namespace tumble::sim
