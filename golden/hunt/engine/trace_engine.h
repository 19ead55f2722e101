#pragma once

#include <filesystem>

#include "golden/engine/project.h"
#include "golden/hunt/judge/trace.h"
#include "tumble/replay/log_reader.h"

namespace tumble::hunt {

/// Runs a scene with the engine of a tumble.toml, in a folder of its own, and reads the session that it writes. An
/// engine that ends with a status other than 0, is ended by a signal or its time limit, or writes fewer steps than the
/// scene has gives a session that fails. The engine stays in the process group of the caller; where it is late, all
/// that the group was joined by is ended. scratch: where the folder is made; empty: the system's place. The bounds of a
/// session that Tumble wrote are those of the scene's method; of any other those of method layered with one substep.
///
/// Errors. kBadInput: status 2, the engine's word for a scene that it cannot run, or a scene that is none.
/// kCannotFinish: no folder, or a command that does not start.
Result<Trace> trace_engine(const golden::EngineProject& project, const sim::SceneDef& scene,
                           const std::filesystem::path& scratch = {});

/// The session of an engine that a log holds, of a scene that the engine was given. No other session can be asked for:
/// `again` is empty, which a caller that judges relations sets. Errors (kBadInput): a scene that is none.
Result<Trace> trace_of_log(replay::LogReader& log, const sim::SceneDef& scene, const golden::EngineProject& project);

}  // namespace tumble::hunt
