#pragma once

#include <string>

#include "tumble/replay/log_writer.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// Writes into the header of a finished log why its session may have had more steps (Declared::cut_short): copies the
/// log, its chunks byte for byte, puts the copy in its place, and sets summary.bytes. No effect without a reason, or
/// where the path names no regular file. Errors (kCannotFinish): the log cannot be read or written, and stays as it
/// was.
Status keep_end_reason(const std::string& path, const std::string& reason, LogSummary& summary);

}  // namespace tumble::replay
