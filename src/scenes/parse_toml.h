#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "src/scenes/problem.h"

namespace tumble::scenes {

/// Text as a TOML tree, or nothing and a report. `source` becomes the path in every source region; leave it empty for
/// the scene's own file, whose name the problem knows.
///
/// Any bytes are safe. The parser bounds its memory by the text's length, but its destructors recurse over dotted keys.
/// Text with more dots in a line than any scene has is therefore refused before it is parsed.
std::optional<toml::table> parse_toml(std::string_view text, const std::string& source, Problem& problem);

}  // namespace tumble::scenes
