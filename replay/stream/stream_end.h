#pragma once

#include <string>
#include <vector>

#include "replay/stream/stream_reader.h"

/// How a stream ends, in words. The stream has a start.
namespace tumble::replay {

/// Why the session may have had more steps than the stream has, for later readers of its log, which see a whole file.
/// Empty: the stream is whole.
std::string cut_short(const StreamReader& stream);

/// What is wrong with the end, for the one who reads the stream.
std::vector<std::string> end_warnings(const StreamReader& stream);

}  // namespace tumble::replay
