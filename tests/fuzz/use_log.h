#pragma once

#include <memory>

#include "replay/byte_memory.h"

namespace tumble::fuzz {

/// Opens a log, if it is one, and does with it all that a program may: reads every step, verifies, recovers, measures,
/// replays.
void use_log(const replay::MemoryFile& file);

}  // namespace tumble::fuzz
