#pragma once

#include <optional>

#include "tumble/sim/scene.h"

namespace tumble::hunt {

/// A scene with others far away, which need what an engine may take from all bodies at once: many sweeps, wide sums,
/// deep overlaps, substeps for fast bodies. `where`: m, along x; nothing of the scene comes near.
struct Neighboured {
  sim::SceneDef scene;
  double where = 0;
};

/// The scene with a tower, a weight that falls on a pole, two boxes inside each other and a bullet before a plate.
/// None: there is no room for them.
std::optional<Neighboured> with_neighbours(const sim::SceneDef& scene);

}  // namespace tumble::hunt
