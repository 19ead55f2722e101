#pragma once

#include <cstdint>

namespace tumble::sim {

/// The name of a body in scenes, inputs, logs and reports: unique, never reused, 1 … kBodyIdMax. No result of the
/// simulation depends on an id.
using BodyId = std::uint64_t;
inline constexpr BodyId kBodyIdMax = (BodyId{1} << 53) - 1;  ///< exact in JSON and in a double

/// The row of a body in the columns of `Bodies` (ascending id). Rows move when a body is thrown in or removed.
using BodyIndex = std::uint32_t;
inline constexpr BodyIndex kGround = 0xffffffffU;  ///< stands for the half-space z <= 0 where a body is expected

}  // namespace tumble::sim
