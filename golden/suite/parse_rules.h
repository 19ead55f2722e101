#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/golden/case_rules.h"
#include "tumble/sim/result.h"

/// metrics.toml as text: read, and written again with other values.
namespace tumble::golden {

/// Errors (kBadInput): "<file>:<line>:<column>: …" for anything unknown or out of range, as in scenes.
Result<CaseRules> parse_rules(std::string_view text, std::string_view file_name);

/// Reads and parses a file of rules. Errors: read_text's and parse_rules'.
Result<CaseRules> read_rules(const std::filesystem::path& file);

/// The text with other values; all else stays, comments included. values: one a metric, none for null.
/// Errors (kBadInput): a layout that cannot be edited line by line.
Result<std::string> with_values(const std::string& text, const std::string& file_name, const CaseRules& rules,
                                const std::vector<std::optional<double>>& values);

}  // namespace tumble::golden
