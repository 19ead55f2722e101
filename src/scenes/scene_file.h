#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

namespace tumble::scenes {

/// Reads a scene: TOML text in, the resolved scene out, with generators expanded, ids given, times turned into steps
/// and every key checked. docs/scenes.md is the format. Touches no file.
///
/// file_name: for messages, and for the scene's name where it gives none (the file's name without its ending; the
/// folder's name if that is "scene").
/// overrides: "key=value" each, as `--set` takes them, applied to the text's tree in order and then checked like the
/// rest: "grid.rows=7", "grid.2.rows=7", "world.dt=0.01". Where one of them sets world.steps or world.seconds, inputs
/// after the new end are left out.
///
/// Any bytes give a scene or an error, in bounded time and memory (16 MiB of text, sim::kBodiesMax bodies).
/// Errors: bad_input, "<file>:<line>:<column>: <table> key <key>: found <x>, wanted <y>", or `--set <argument>` in
/// front where the value came from there; cannot_finish if memory runs out.
///
/// create_world() may still refuse the result.
Result<sim::SceneDef> parse_scene(std::string_view toml_text, std::string_view file_name,
                                  std::span<const std::string> overrides = {});

}  // namespace tumble::scenes
