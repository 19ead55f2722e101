#pragma once

#include "replay/codec/zstd_frame.h"
#include "tumble/golden/expected.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

/// schema/golden.capnp's message. Errors: memory.
Result<replay::MessageBytes> encode(const Expected& expected);

/// Errors (kDamaged): columns whose sizes do not fit together, ids or steps that do not ascend, counts beyond limits.
Result<Expected> decode(const replay::MessageBytes& message);

}  // namespace tumble::golden
