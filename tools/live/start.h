#pragma once

#include "replay/live/live_session.h"
#include "tools/arguments/live_options.h"
#include "tools/output/exit.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

namespace tumble::tools {

/// A session that the arguments ask for, not begun yet.
struct LiveStart {
  std::string name;  ///< of the scene or log, for the window's title
  sim::Camera camera;
  replay::LiveOptions options;
  Exit verdict = Exit::kSame;  ///< kDamaged: --from names a log that is not whole
};

/// Reads scene or log; writes nothing. Errors (kBadInput): wrong arguments, a scene or a log that cannot be read, an
/// output that is refused.
Result<LiveStart> read_live_start(const LiveArguments& arguments);

}  // namespace tumble::tools
