#pragma once

#include "replay/stream/stream_step.h"
#include "tumble/replay/extras.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// Keeps the hashes of the start of a stream of hashes, which no step has: a text of 16 digits in a channel of state 0
/// for each class. Declares these channels; such a stream has no others. A start without hashes adds nothing.
Status declare_start_hashes(const StreamStep& start, Declared& declared);

}  // namespace tumble::replay
