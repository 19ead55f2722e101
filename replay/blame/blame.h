#pragma once

#include "replay/blame/blame_answer.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/sim/result.h"

/// From a value of a body back to what wrote it: phase, contacts, input or scene. No log holds this; this build
/// computes it by taking steps again from the nearest keyframe with an observer.
namespace tumble::replay {

/// Explains a value. Every step that an answer speaks of was taken again by this build and is equal to the log's:
/// inputs, phase words where they mean the same, state hash, counters. Errors (kBadInput): a field or a body that does
/// not exist after that step; a step that the log does not hold; another engine's log. (kCannotFinish): this build
/// takes a step otherwise than the log; the message names the step, and what can be asked instead. Those of the log.
Result<Blame> blame(LogReader& log, const BlameQuestion& question, const Progress& progress = {});

}  // namespace tumble::replay
