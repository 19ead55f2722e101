#pragma once

#include "tumble/sim/result.h"

namespace tumble::tools {

/// The exit status of every command.
enum class Exit : int {
  kSame = 0,          ///< done; the same; passed
  kDifference = 1,    ///< a difference was found
  kBadInput = 2,      ///< bad usage or bad input
  kDamaged = 3,       ///< a file is damaged or torn, even where its whole part is fine
  kCannotFinish = 4,  ///< full disk, memory, a step that fails, an interruption
};

/// The status that goes with an error.
Exit exit_for(const Error& error);

}  // namespace tumble::tools
