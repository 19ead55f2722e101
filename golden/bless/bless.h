#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tumble/golden/history.h"
#include "tumble/golden/suite.h"
#include "tumble/process/job_pool.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

struct BlessOptions {
  std::filesystem::path suite;
  std::vector<std::string> names;  ///< of cases; empty: all
  std::string reason;              ///< one line
  bool dry_run = false;            ///< reports the changes and writes nothing
  process::PoolOptions pool;
  std::filesystem::path report =
      {};  ///< of a check elsewhere, whose sessions are accepted instead; empty: cases are run
};

struct BlessReport {
  std::vector<Blessing> blessed;       ///< changed cases (in a dry run: cases that would change), by name
  std::vector<std::string> unchanged;  ///< cases whose bits and values agree with their golden
};

/// Runs cases and accepts their present results: writes expected.tumble and the values of metrics.toml; bounds stay as
/// they are. Writes nothing for any case unless every case can be blessed. Errors (kBadInput): a reason that is
/// empty or has several lines, an unknown case, a case that did not run to its end, a metric out of its bounds or null
/// (change the bound, with its reason, in metrics.toml first), a folder that may not be written. kCannotFinish: the
/// disk, cancelled.
Result<BlessReport> bless_cases(const BlessOptions& options);

}  // namespace tumble::golden
