#pragma once

#include <filesystem>

#include "tools/bisect/settings.h"
#include "tumble/sim/result.h"

namespace tumble::tools::bisect {

/// Takes build, run, scene and shell from the tumble.toml of `from` or the nearest folder above it, as far as the
/// settings do not name them; the program becomes this one, which judges the case of an engine. Leaves the settings
/// where there is none. Errors: those of a wrong tumble.toml; kBadInput where it lies outside a clone.
Status take_project(const std::filesystem::path& from, Settings& settings);

}  // namespace tumble::tools::bisect
