#pragma once

#include <functional>

#include "golden/run/judge_laws.h"

namespace tumble::golden {

/// Takes a case's session once more. Before each step the state is written as a log writes a snapshot and read back
/// into a world of its own, which takes the step too: state, hashes of phases, counts and hidden state have to be those
/// of the session. Each step is taken twice, so the time grows with the steps alone. Sets CaseResult::gone_on; the
/// first step that differs is a problem of the case. No other engine can load a state: its case gets words that say so.
void go_on_from_each_step(const LawSession& session, const CaseRules& rules, CaseResult& result);

/// What a snapshot is read back as. Tests give one that loses something.
using Reload = std::function<Result<sim::WorldState>(const sim::WorldState& state)>;

/// The first difference of a scene's session, in words; empty: none. steps: how many were taken. Errors: the session
/// ends early.
Result<std::string> first_step_gone_on_otherwise(const sim::SceneDef& scene, const Reload& reload, std::uint64_t& steps,
                                                 Hash128& final_hash);

/// A state through the bytes of a log's chunk. Errors: the codec's.
Result<sim::WorldState> saved_and_loaded(const sim::WorldState& state);

}  // namespace tumble::golden
