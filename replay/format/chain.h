#pragma once

#include "replay/format/step_record.h"
#include "src/base/hash.h"

namespace tumble::replay {

/// The chain: chain(k) = XXH3-128 of chain(k − 1) and the fields of step k (number, dt, inputs, phase words, state
/// hash, counters); chain(0) of the state hash of state 0. Two sessions are the same up to step k exactly if their
/// chains there are, whatever bytes their logs hold.
Hash128 chain_start(const Hash128& state_hash_0);
Hash128 chain_next(const Hash128& before, const StepRecord& record);

}  // namespace tumble::replay
