#pragma once

#include "golden/hunt/judge/relation.h"
#include "tumble/replay/log_reader.h"

/// Two builds' logs of one scene: `mine` of this build, `other` of the other.
namespace tumble::hunt {

/// This build's log of the trace's session, in memory. Errors: it cannot be recorded or read back.
Result<replay::LogReader> log_of(const Trace& trace);

/// How two starts are compared.
enum class Starts : std::uint8_t {
  kEveryBit,  ///< every value that a scene gives a body
  kPlaced,  ///< the same bodies, with equal masses, sizes, places and speeds; of materials, the builds' measures speak
};

/// Broken: the bodies at the start differ, in the headers or in state 0. It is of step 0 and phase "start".
Judgement compare_starts(replay::LogReader& mine, replay::LogReader& other, Starts how);

/// Broken: any bit differs that `tumble diff` compares: the start, inputs, phase hashes, states, counters, hidden
/// state, the number of steps, or a value of the header that a step depends on.
Judgement compare_logs(replay::LogReader& mine, replay::LogReader& other);

}  // namespace tumble::hunt
