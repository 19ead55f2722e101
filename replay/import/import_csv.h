#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "replay/format/progress.h"
#include "replay/import/csv_steps.h"
#include "replay/log/byte_io.h"
#include "replay/log/log_reader.h"
#include "replay/log/log_writer.h"
#include "src/base/result.h"

/// A table of states, as any engine can print one, made into a log that can be compared, measured and drawn.
/// docs/other_engines.md is the format.
namespace tumble::replay {

/// Errors: the log's.
Result<SessionLike> session_like(LogReader& log);

struct ImportOptions {
  std::vector<std::string> settings;  ///< "key: value", as the table's own lines say it; these win
  std::optional<SessionLike> like = {};
};

/// Where the log goes; asked once, when all of the table was found good.
using MakeSink = std::function<Result<std::unique_ptr<ByteSink>>()>;

/// Reads the table twice: first all of it for errors, then to write. `name` is for messages. The first step of the
/// table becomes state 0, the others steps 1, 2, …; a body that appears later becomes an input throw, one that is
/// missing an input remove. Errors: "<name>:<line>:<column>: found …, wanted …" (kBadInput); writing; a stop asked for
/// by `progress` (kCannotFinish).
Result<LogSummary> import_csv(std::string_view text, const std::string& name, const MakeSink& make_sink,
                              const ImportOptions& options = {}, const Progress& progress = {});

}  // namespace tumble::replay
