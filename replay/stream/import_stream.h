#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "replay/stream/rollback_check.h"
#include "replay/stream/stream_reader.h"
#include "tumble/replay/byte_io.h"
#include "tumble/replay/log_writer.h"
#include "tumble/replay/progress.h"
#include "tumble/sim/result.h"

/// Makes a log of a recorder's stream. docs/recorder_stream.md says what becomes what.
namespace tumble::replay {

struct StreamImport {
  LogSummary log;
  RollbackCheck rollbacks;
  std::vector<std::string> warnings;  ///< oddness that does not hinder the import
  /// The step that no log can hold, with its byte in the stream; empty: there is none. The log ends before it, and says
  /// so to later readers (Declared::cut_short).
  std::string refused;
};

/// Reads the stream twice, first to check all of it, then to write the log. make_sink: called once, in between, when
/// the start is known to be sound: an error before costs no older file. Steps that a rewind took back are left out in
/// favour of those recorded after it, which say what became of them (Extras::superseded). Errors. kBadInput: a record
/// that cannot be, or a start that no log can hold, with its byte in the stream. kCannotFinish: writing fails, or
/// `progress` stops the work.
Result<StreamImport> import_stream(const StreamReader& stream,
                                   const std::function<Result<std::unique_ptr<ByteSink>>()>& make_sink,
                                   const Progress& progress = {});

}  // namespace tumble::replay
