#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "replay/stream/stream_format.h"

/// Names of a stream as a log has them.
namespace tumble::replay {

/// A name as a log keeps it: without control characters, of at most 200 bytes, or fewer.
std::string name_for_log(const std::string& name, std::size_t bytes_max = kStreamNameBytesMax);

/// The phases of a log for those of a stream, each of another name: "solve", "solve#2". The recorder refuses two of one
/// name; an older one took them. notes: gains a line for each that has another name now.
std::vector<std::string> phase_names(const std::vector<std::string>& theirs, std::vector<std::string>& notes);

}  // namespace tumble::replay
