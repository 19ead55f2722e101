#pragma once

#include <functional>
#include <string>
#include <vector>

#include "golden/bundle/bundle_set.h"
#include "tumble/golden/suite_result.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

/// What a shard's report.json has beside its cases.
struct ShardReport {
  std::vector<std::string> problems;
  std::vector<CanaryResult> canaries;
};

/// Reads the report.json of a bundle; no more than one case is held at a time. take: called with each case, in order.
/// Errors (kDamaged): text that no check wrote, or cases that are not those that the bundle names.
Result<ShardReport> read_results(const Bundle& bundle, const std::function<void(CaseResult result)>& take);

}  // namespace tumble::golden
