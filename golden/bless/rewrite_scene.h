#pragma once

#include <span>
#include <string>
#include <string_view>

#include "src/base/result.h"

namespace tumble::golden {

/// A scene's text with overrides (`--set`) built in and another name. Where there is nothing to change the text comes
/// back as it is; otherwise comments are lost, and every number reads back to the same bits. Errors: as
/// scenes::parse_scene. Not a part of the scene library: the writer of toml++ asks log10 where to break lines, and
/// nothing that reads a scene may call libm.
Result<std::string> rewrite_scene(std::string_view toml_text, std::string_view file_name, std::string_view name,
                                  std::span<const std::string> overrides);

}  // namespace tumble::golden
