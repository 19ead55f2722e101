#pragma once

#include "tumble/replay/compare.h"

namespace tumble::replay {

/// Channels, and phases with hashes of another engine, that one of two logs declares and the other does not. Both are
/// logs of one engine.
OnlyInOne only_in_one(const LogHeader& a, const LogHeader& b);

}  // namespace tumble::replay
