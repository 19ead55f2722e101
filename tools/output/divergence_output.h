#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "tools/output/text.h"
#include "tumble/replay/divergence.h"

namespace tumble::tools {

/// {"identical":…, "steps":…, "first":null|{…}}: the common part of `replay --json` and `diff --json`.
Json comparison_json(bool identical, std::uint64_t steps, const std::optional<replay::Divergence>& first);

/// The bits of a double or of a word, as 0x and 16 hexadecimal digits.
std::string hex_text(double value);
std::string hex_text(std::uint64_t word);

/// Prints the first difference for people, in a few aligned lines.
void print_divergence(const replay::Divergence& first);

}  // namespace tumble::tools
