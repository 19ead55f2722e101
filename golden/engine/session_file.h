#pragma once

#include <string>
#include <vector>

#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

/// A log of the session that an engine wrote to `path`: the file itself where it is a log; else a recorder's stream
/// or a table of comma-separated values, converted to a log at `converted`. like: gives the keys, dt, sizes and masses
/// that the table lacks; may be null. warnings: gets the oddnesses of the table. Returns the path of the log. Errors:
/// kCannotFinish where there is no file or an empty one; import_csv's.
Result<std::string> log_of_session(const std::string& path, const std::string& converted, replay::LogReader* like,
                                   std::vector<std::string>& warnings);

}  // namespace tumble::golden
