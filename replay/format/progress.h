#pragma once

#include <cstdint>
#include <functional>

namespace tumble::replay {

/// A callback after each step, with the numbers of finished and planned steps. Returning false stops the work as if the
/// end were reached. May be empty.
using Progress = std::function<bool(std::uint64_t done, std::uint64_t total)>;

}  // namespace tumble::replay
