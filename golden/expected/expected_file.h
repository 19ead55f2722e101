#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "tumble/golden/expected.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

/// Above this size the phase words of a golden lose detail, bytes: git keeps every version of every golden.
inline constexpr std::size_t kGoldenBytesWanted = 300'000;
/// No golden decodes to more than this, bytes.
inline constexpr std::size_t kGoldenBytesMax = std::size_t{256} << 20;

/// A longer text of a scene is not kept, bytes: for the same reason.
inline constexpr std::size_t kSceneTextMax = 100'000;

/// expected.tumble: one record of docs/log_format.md, of kind golden, and nothing else. Errors: memory.
Result<std::vector<std::byte>> pack(Expected expected);

/// Errors, each with `name` (the path) in front: kDamaged for an empty file, one that is torn, has other bytes than
/// were written or more than one record; kBadInput for something that is no golden or needs a newer program.
Result<Expected> unpack(std::span<const std::byte> file, const std::string& name);

}  // namespace tumble::golden
