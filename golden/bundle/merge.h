#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "tumble/golden/suite_result.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

struct MergeOptions {
  std::vector<std::filesystem::path> bundles;  ///< report folders of all shards of one check, in any order
  std::filesystem::path report;                ///< gets the files of failed cases
  /// Called once all bundles are read, before the first file is written; an error ends the merge.
  std::function<Status()> make_ready;
  /// Called as each shard was read; may be empty.
  std::function<void(std::size_t done, std::size_t total)> progress;
};

/// The result of the check of the whole suite, from the bundles of its shards: as if it had not been split; each canary
/// was asked by one of them. Seconds are the slowest shard's, the date is the earliest. A merge
/// that is refused touches nothing. Errors: open_bundles', read_results', make_ready's; kCannotFinish: the disk.
Result<SuiteResult> merge_bundles(const MergeOptions& options);

}  // namespace tumble::golden
