#pragma once

#include <filesystem>
#include <vector>

#include "golden/hunt/folder.h"
#include "tumble/sim/result.h"

namespace tumble::hunt {

/// Merges the folders of all shards of one hunt into a new one: tallies added, findings by number, their scenes and
/// cases copied. Errors name every folder that is wrong, the text found and the one wanted. kBadInput: a shard that is
/// missing, there twice, not at its end or of another hunt, or an `out` that holds a hunt; kDamaged: a file that cannot
/// be read; kCannotFinish: the disk.
Result<HuntState> merge_hunts(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& out);

}  // namespace tumble::hunt
