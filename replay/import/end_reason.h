#pragma once

#include <string>

#include "tumble/replay/log_writer.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// The path by which a log that is begun now will be found, whatever folder the program goes to.
std::string place_of_log(const std::string& path);

/// Writes into the header of a finished log why its session may have had more steps (Declared::cut_short): copies the
/// log, its chunks byte for byte, puts the copy in its place, and sets summary.bytes. No effect without a reason or a
/// path, or where the path is a device or a pipe. Errors (kCannotFinish): the log cannot be read or written, or is no
/// longer the one that the summary speaks of; it stays as it was.
Status keep_end_reason(const std::string& path, const std::string& reason, LogSummary& summary);

}  // namespace tumble::replay
