#pragma once

#include "tumble/replay/extras.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/hash.h"

namespace tumble::replay {

/// The chain is a hash over a session from its start. chain(0) is the XXH3-128 of the state hash of state 0. chain(k)
/// is the XXH3-128 of chain(k − 1) and the fields of step k: number, dt, inputs, phase words, state hash, counters. The
/// hash of the extras comes last, where there are values or contacts. Two sessions are equal up to step k exactly if
/// chain(k) is equal, whatever bytes the logs hold.
Hash128 chain_start(const Hash128& state_hash_0, const Extras& extras_0);
Hash128 chain_next(const Hash128& before, const StepRecord& record);
/// The same over a step without its extras.
Hash128 chain_next_of_states(const Hash128& before, const StepRecord& record);

}  // namespace tumble::replay
