#pragma once

#include "golden/hunt/judge/relation.h"
#include "tumble/replay/log_reader.h"

/// The session of a scene by this build, and the log of it by another build.
namespace tumble::hunt {

/// How two starts are compared.
enum class Starts : std::uint8_t {
  kEveryBit,  ///< every value that a scene gives a body
  kPlaced,  ///< the same bodies, with equal masses, sizes, places and speeds; of materials, the builds' measures speak
};

/// Broken: the bodies at the start differ, in the headers or in state 0. It is of step 0 and phase "start".
Judgement compare_starts(const Trace& mine, replay::LogReader& other, Starts how);

/// Broken: the sessions have another number of steps.
Judgement compare_lengths(const Trace& mine, const replay::LogReader& other);

/// The error of a log of another build, as a judgement.
Judgement log_unread(std::uint64_t step, const Error& error);

/// Broken: any bit differs that `tumble diff` compares: the start, inputs, phase hashes, states, counters, hidden
/// state, the number of steps, or a value of the header that a step depends on. Records the session once more, in
/// memory. Not applicable: this build cannot record it.
Judgement compare_bits(const Trace& mine, replay::LogReader& other);

}  // namespace tumble::hunt
