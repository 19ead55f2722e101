#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "tumble/replay/step_record.h"

namespace tumble::replay {

/// The phases of a log that `import` made of a recorder's stream of hashes: the classes that each step has a hash of,
/// in their order. Such a log holds no bodies and no values.
inline constexpr std::array<std::string_view, 5> kHashedClasses = {"inputs", "states", "contacts", "phase_hashes",
                                                                   "channels"};

inline bool holds_hashes_only(const LogHeader& header) {
  return header.engine && std::ranges::equal(header.phases, kHashedClasses);
}

}  // namespace tumble::replay
