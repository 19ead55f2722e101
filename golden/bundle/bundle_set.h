#pragma once

#include <filesystem>
#include <vector>

#include "golden/bundle/manifest.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

struct Bundle {
  std::filesystem::path folder;
  Manifest manifest;
};

/// Opens the bundles of one check and returns them by shard, 1 … N, each once. Reads every file that a bundle names and
/// compares its hash.
///
/// Errors list every bundle that is wrong, a line each, with its folder and shard, the text found and the one wanted.
/// The commit, program, suite, selection, options and N that most bundles have are the wanted ones.
/// kDamaged: a file is not as it was written. kBadInput: a shard is missing, there twice, or of another check.
Result<std::vector<Bundle>> open_bundles(const std::vector<std::filesystem::path>& folders);

}  // namespace tumble::golden
