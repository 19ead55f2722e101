#pragma once

#include <filesystem>
#include <string>

#include "golden/run/run_session.h"
#include "golden/suite/suite.h"
#include "tumble/sim/result.h"

/// External engines: a command of a case reads a scene and writes a log.
namespace tumble::golden {

/// In single quotes where the shell needs them.
std::string shell_quoted(const std::string& word);

/// " --suite DIR", for a command line; empty for the folder `golden`, which commands find by themselves.
std::string suite_option(const std::filesystem::path& suite);

/// The command line with the paths of a scene and a log filled in.
std::string engine_command(const std::string& command, const std::string& scene, const std::string& log);

/// A line for the folder that the check ran in: the command, in the suite's folder as it runs there, for a case. It
/// leaves its log in that folder.
std::string engine_line(const std::string& command, const std::filesystem::path& suite, const CaseFolder& folder);

/// Runs the command by sh in the suite's folder and reads the log that it writes. Errors (kCannotFinish): a status
/// other than 0, no log; the message has the end of its output. The log lies in a new folder in `scratch`, or where
/// temporary files lie, until it is read.
Result<Session> run_engine(const std::string& command, const std::filesystem::path& suite, const std::string& scene,
                           const std::filesystem::path& scratch = {});

}  // namespace tumble::golden
