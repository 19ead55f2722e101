#pragma once

#include <string>

#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

namespace tumble::hunt {

/// A scene as the TOML that `tumble record` takes (docs/scenes.md), every number to its last bit; keys with their
/// default are left out, and so are camera and light. Generators of the original are boxes here.
std::string scene_text(const sim::SceneDef& scene);

/// A scene as text, and the scene that the text is.
struct TextScene {
  std::string text;
  sim::SceneDef scene;
};

/// Writes a scene and reads it again, until the text stands for itself to the last bit: reading normalises
/// orientations. Errors (kBadInput): a scene that no file may hold.
Result<TextScene> settled(const sim::SceneDef& scene);

}  // namespace tumble::hunt
