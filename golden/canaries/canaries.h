#pragma once

#include <cstddef>

#include "golden/canaries/canary_roll.h"
#include "tumble/golden/judge.h"

namespace tumble::golden {

/// Records a tiny session, spoils golden, bounds, log or file in one way after the other and judges each as a case. The
/// first canary is a control: nothing is spoilt, and it must pass. Every check asks all canaries, each in one of its
/// shards; if one is not caught, no verdict of that check can be trusted.
CanaryRoll run_canaries(Judge judge_function = judge, std::size_t shard = 1, std::size_t shards = 1);

}  // namespace tumble::golden
