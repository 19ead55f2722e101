#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "tumble/replay/step_record.h"

namespace tumble::replay {

/// The phases of a log that `import` made of a recorder's stream of hashes: the classes that each step has a hash of,
/// in their order. Such a log holds no bodies and no values.
inline constexpr std::array<std::string_view, 5> kHashedClasses = {"inputs", "states", "contacts", "phase_hashes",
                                                                   "channels"};

/// An engine may call its own phases so; its bodies then tell that values were kept.
inline bool holds_hashes_only(const LogHeader& header) {
  return header.engine && header.scene.boxes.empty() && std::ranges::equal(header.phases, kHashedClasses);
}

/// Whether one of two logs holds the values that the other holds hashes of: both have the lengths of the steps alone.
inline bool one_holds_hashes_only(const LogHeader& a, const LogHeader& b) {
  return holds_hashes_only(a) != holds_hashes_only(b);
}

/// Whether no place of a body is known in one of two logs at least.
inline bool lack_states(const LogHeader& a, const LogHeader& b) { return holds_hashes_only(a) || holds_hashes_only(b); }

/// The channels of the start's hashes in such a log, one for each class. A log of an older import has none.
inline std::string start_channel(std::string_view hashed_class) { return "start." + std::string(hashed_class); }

inline bool has_start_hashes(const LogHeader& header) {
  return std::ranges::all_of(kHashedClasses, [&](std::string_view hashed_class) {
    return header.declared.find(start_channel(hashed_class)) != header.declared.channels.size();
  });
}

}  // namespace tumble::replay
