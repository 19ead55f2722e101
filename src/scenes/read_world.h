#pragma once

#include "src/scenes/read_inputs.h"
#include "src/scenes/table_reader.h"
#include "tumble/sim/scene.h"

namespace tumble::scenes {

/// name, title and category, from the top of the file.
void read_titles(TableReader& top, std::string_view file_name, sim::SceneDef& scene);

/// [world] but for the ground's material: the stepper's parameters and the number of steps.
InputClock read_world(TableReader& top, sim::SceneDef& scene);

/// [camera] and [light].
void read_view(TableReader& top, sim::SceneDef& scene);

}  // namespace tumble::scenes
