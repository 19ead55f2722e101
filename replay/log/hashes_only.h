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

/// Whether one of two logs holds the values that the other holds hashes of: both have the lengths of the steps alone.
inline bool one_holds_hashes_only(const LogHeader& a, const LogHeader& b) {
  return holds_hashes_only(a) != holds_hashes_only(b);
}

}  // namespace tumble::replay
