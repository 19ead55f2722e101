#pragma once

#include <cstdint>
#include <optional>
#include <string>

/// Numbers in arguments. Independent of the locale.
namespace tumble::tools {

/// A decimal number and nothing else; none if `text` is not one.
std::optional<std::uint64_t> parse_whole(const std::string& text);
std::optional<double> parse_number(const std::string& text);

}  // namespace tumble::tools
