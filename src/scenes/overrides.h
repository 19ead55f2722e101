#pragma once

#include <string_view>

#include "src/scenes/toml.h"
#include "tumble/sim/result.h"

namespace tumble::scenes {

/// Sets one value in a scene's TOML tree: "grid.rows=7", "grid.2.rows=7", "world.dt=0.01", "material.friction=0.9".
/// The value is read and checked later like the file's own. Its source region has the path "--set <argument>", so that
/// messages name the argument. A key that excludes another one (steps and seconds, mass and
/// density, orientation and axis with degrees, step and time) replaces it.
/// Errors: not "key=value", a value that is neither TOML nor a bare word, a table that the scene does not have.
Status apply_override(toml::table& root, std::string_view argument);

}  // namespace tumble::scenes
