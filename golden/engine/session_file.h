#pragma once

#include <optional>
#include <string>
#include <vector>

#include "golden/engine/project.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

/// The session of an engine as a log.
struct SessionLog {
  std::string path;
  std::vector<std::string> warnings;  ///< oddnesses of a table or a stream
  /// The stream has no last frame: the engine ended without closing its recorder. A sentence; empty: it is whole.
  std::string unfinished;
  /// The stream has a step that no log can hold, and the log ends before it. A sentence; empty: there is none.
  std::string refused;
};

/// ".tumble", ".tumblestream", ".npz" or ".csv", by the first bytes of what an engine wrote.
const char* ending_of_session(const std::string& path);

/// A log of the session that an engine wrote to `path`: the file itself where it is a log; else a recorder's stream
/// or a table of comma-separated values, converted to a log at `converted`. like: gives the keys, dt, sizes and masses
/// that the table lacks; may be null. Errors: kCannotFinish where there is no file or an empty one; kDamaged: a stream
/// with a frame that is not as it was written; import_csv's.
Result<SessionLog> log_of_session(const std::string& path, const std::string& converted, replay::LogReader* like);

/// The same of a file to which the engine of a project still writes: of its complete steps. None where there is no
/// complete step yet, or nothing that can be read as one.
std::optional<std::string> log_so_far(const std::string& path, const std::string& converted, replay::LogReader* like,
                                      const EngineProject& project);

}  // namespace tumble::golden
