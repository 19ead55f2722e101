#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

/// Arguments that several commands share, with errors that say what was found and what is wanted.
namespace tumble::tools {

/// A decimal number and nothing else; none if `text` is not one. Independent of the locale.
std::optional<std::uint64_t> parse_whole(const std::string& text);
std::optional<double> parse_number(const std::string& text);

/// Declares an option for a whole number low … high.
CLI::Option* add_whole(CLI::App& app, const std::string& name, std::optional<std::uint64_t>& target, std::uint64_t low,
                       std::uint64_t high, const std::string& description);

/// Declares an option for a number above 0, up to high.
CLI::Option* add_positive(CLI::App& app, const std::string& name, std::optional<double>& target, double high,
                          const std::string& description);

/// Declares `--json`.
CLI::Option* add_json(CLI::App& app, bool& target);

/// Declares `--threads`, 1 … 256; results do not depend on it.
CLI::Option* add_threads(CLI::App& app, std::optional<std::uint64_t>& target);

}  // namespace tumble::tools
