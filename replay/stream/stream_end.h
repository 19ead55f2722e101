#pragma once

#include <string>

#include "replay/stream/stream_reader.h"

/// How a stream ends, in words.
namespace tumble::replay {

/// Whether the recorder was stopped before it wrote its last frame.
bool was_stopped(const StreamCondition& condition);

/// Why the session may have had more steps than the stream has, for later readers of its log, which see a whole file.
/// Empty: the stream is whole. The stream has a start.
std::string cut_short(const StreamReader& stream);

}  // namespace tumble::replay
