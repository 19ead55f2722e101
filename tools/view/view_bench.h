#pragma once

#include "tools/bench/bench.h"

namespace tumble::tools {

/// `tumble bench view`: how long the served page of a large session lets one wait, and the memory of its server.
Result<Exit> bench_view(const BenchOptions& options);

}  // namespace tumble::tools
