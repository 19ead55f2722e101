#pragma once

#include <optional>
#include <string_view>

#include "tumble/sim/hash.h"

namespace tumble {

/// The hash that to_string() wrote: 32 hexadecimal digits. None for any other text.
std::optional<Hash128> parse_hash(std::string_view digits);

}  // namespace tumble
