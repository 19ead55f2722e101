#pragma once

#include <cstddef>
#include <string>

#include "tumble/sim/result.h"

namespace tumble::tools {

/// The K-th of N parts.
struct Shard {
  std::size_t k = 1, n = 1;
};

/// Reads --shard: "2/5"; empty: the whole; "auto": what the environment of a build system says, in this order:
///
/// | variables | of | first part |
/// |---|---|---|
/// | TUMBLE_SHARD=K/N | scripts, GitHub's matrix | 1 |
/// | CI_NODE_INDEX, CI_NODE_TOTAL | GitLab's `parallel` | 1 |
/// | TEST_SHARD_INDEX, TEST_TOTAL_SHARDS | Bazel's `shard_count`; TEST_SHARD_STATUS_FILE is touched, as Bazel asks | 0
/// |
///
/// Errors (kBadInput): other text; "auto" without any of these, or with one that is no shard: the message names it.
Result<Shard> read_shard(const std::string& text);

}  // namespace tumble::tools
