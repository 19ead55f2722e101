#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "golden/engine/engine_run.h"
#include "golden/engine/project.h"
#include "golden/run/run_session.h"
#include "tumble/golden/suite.h"
#include "tumble/sim/result.h"

/// External engines: a case names an engine that reads its files and writes a session.
namespace tumble::golden {

/// " --suite DIR", for a command line; empty for the folder `golden`, which commands find by themselves.
std::string suite_option(const std::filesystem::path& suite);

/// The engine of a case, and the case's files for it.
struct CaseEngine {
  EngineProject project;
  RunFiles files;  ///< without a log
};

/// [engine]: the engine of the tumble.toml in the suite's folder or the nearest one above, with the case's files.
/// [command]: that command, by sh in the suite's folder, with the case's scene. Errors (kBadInput): no tumble.toml, or
/// a wrong one. Precondition: rules.is_external().
Result<CaseEngine> engine_of_case(const CaseFolder& folder, const CaseRules& rules, const std::filesystem::path& suite);

/// A line for the folder that the check ran in: the engine's command for a case, in the folder where it runs. The line
/// leaves NAME.tumble in the folder that the check ran in. converts: the engine writes a table or a stream,
/// NAME.recorded, of which `tumble import` makes the log.
std::string engine_line(const CaseEngine& engine, const std::string& name, bool converts = false);

/// Runs the engine once and reads the session that it writes. Errors (kCannotFinish): a status other than 0, no
/// session; the message has the end of its output. The session lies in a new folder in `scratch`, or where temporary
/// files lie, until it is read.
Result<Session> run_engine(const CaseEngine& engine, const std::filesystem::path& scratch = {});

/// Builds the engine of the suite's tumble.toml, once, if one of the cases is a case of [engine]. Errors:
/// engine_of_case()'s; kCannotFinish where a build command fails.
Status build_engine_of(const std::vector<CaseFolder>& cases, const std::filesystem::path& suite,
                       const process::Cancel& cancel = {});

}  // namespace tumble::golden
