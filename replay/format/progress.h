#pragma once

#include <cstdint>
#include <functional>

namespace tumble::replay {

/// Called after each step with the steps done and planned; false stops, as at the end. May be empty.
using Progress = std::function<bool(std::uint64_t done, std::uint64_t total)>;

}  // namespace tumble::replay
