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

/// Makes a log of a recorder's stream and prints what it is. Status 3: the stream is damaged, and the log ends before
/// the damage.
Result<Exit> import_stream_file(const StreamFiles& files);

}  // namespace tumble::tools
