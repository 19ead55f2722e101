#pragma once

#include <string>
#include <vector>

#include "tools/output/exit.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

struct StreamFiles {
  std::string stream;
  std::string output;
  bool json = false;
  bool quiet = false;  ///< no warnings, no summary
};

/// Whether the file begins as a stream of replay/recorder/tumble_recorder.h does.
bool is_stream_file(const std::string& path);

/// What is wrong with a file that is a log, or a stream cut in its first bytes: no table can be looked for in it. Empty
/// where it may be one. start: its first bytes, at least 16 where it has as many.
std::string no_table(const std::string& path, const std::string& start);

/// Makes a log of a recorder's stream and prints what it is. Status 3: the stream is damaged, and the log ends before
/// the damage.
Result<Exit> import_stream_file(const StreamFiles& files);

}  // namespace tumble::tools
