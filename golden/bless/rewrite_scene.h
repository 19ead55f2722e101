#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tumble/sim/result.h"

namespace tumble::golden {

/// A scene's text with overrides (`--set`) built in and another name. Without changes the text comes back as it is;
/// otherwise comments are lost, and every number reads back to the same bits. Errors: as scenes::parse_scene. This
/// function stays outside the scene library: the writer of toml++ breaks lines by log10, and no reader of scenes may
/// call libm.
Result<std::string> rewrite_scene(std::string_view toml_text, std::string_view file_name, std::string_view name,
                                  std::span<const std::string> overrides);

}  // namespace tumble::golden
