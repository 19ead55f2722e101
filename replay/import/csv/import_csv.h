#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "replay/import/csv/csv_steps.h"
#include "tumble/replay/byte_io.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/log_writer.h"
#include "tumble/replay/progress.h"
#include "tumble/sim/result.h"

/// Converts a table of states, as any engine can print one, to a log. The log can be compared, measured and drawn.
/// docs/other_engines.md specifies the format.
namespace tumble::replay {

/// The values of a session that a table may lack. Errors: a step of the log cannot be read.
Result<SessionLike> session_like(LogReader& log);

struct ImportOptions {
  std::vector<std::string> settings;  ///< "key: value"; override the settings of the table
  std::optional<SessionLike> like = {};
  TableMap map = {};
  bool scalar_last = false;  ///< somebody asked that quaternions be read as x y z w; for warnings
  /// Called for each oddness of the table that does not hinder the import: "<name>:<line>:<column>: …".
  std::function<void(const std::string& warning)> warn = {};
};

/// Opens the destination of the log. Called once, after the whole table was checked.
using MakeSink = std::function<Result<std::unique_ptr<ByteSink>>()>;

/// Reads the table twice, first to check all of it, then to write the log. The first step of the table becomes state 0,
/// the others steps 1, 2, …. A body that appears later becomes an input `throw`, a body that disappears an input
/// `remove`. name: for messages. Errors. kBadInput: "<name>:<line>:<column>: found …, wanted …". kCannotFinish: writing
/// fails, or `progress` stops the work.
Result<LogSummary> import_csv(std::string_view text, const std::string& name, const MakeSink& make_sink,
                              const ImportOptions& options = {}, const Progress& progress = {});

}  // namespace tumble::replay
