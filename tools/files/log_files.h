#pragma once

#include <string>

#include "src/files/file_kind.h"
#include "src/files/output_guard.h"
#include "tools/output/exit.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// Opens a log that holds state 0 at least. Errors: LogReader::open's; kDamaged for a log torn before its first chunk.
Result<replay::LogReader> open_log(const std::string& path);

/// Errors (kBadInput): a log of hashes only, which has no body to measure, draw or write.
Status wants_values(const replay::LogReader& log);

/// open_log() and wants_values().
Result<replay::LogReader> open_values(const std::string& path);

/// For an output that is no log: guard.claim(), which also refuses a path where a log or a golden lies, or any other
/// file that is not of the output's kind.
Status claim_output(files::OutputGuard& guard, const std::string& option, const std::string& path,
                    files::FileKind kind);

/// The exit status of a command that has read the intact part of `log`: `verdict` for a whole log; kDamaged, and a line
/// on stderr with the damage, for one that is torn or damaged.
Exit judge(const char* command, const replay::LogReader& log, Exit verdict);

}  // namespace tumble::tools
