#pragma once

#include <filesystem>
#include <string>

#include "tumble/golden/bless.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

struct NewCase {
  std::filesystem::path suite;
  std::string name;
  std::string log;  ///< path of the session that becomes a case
  std::string reason;
  bool dry_run = false;
};

/// Makes a case of a recorded session: scene.toml from the log's scene text and overrides, metrics.toml with measured
/// values and bounds a tenth wider, the golden. Errors: a name that is taken, a log that cannot be read or has no
/// scene text; a session that this build does not reproduce from its scene to the bit (kBadInput).
Result<BlessReport> bless_log(const NewCase& options);

}  // namespace tumble::golden
