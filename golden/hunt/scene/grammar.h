#pragma once

#include <cstdint>

#include "tumble/sim/scene.h"

namespace tumble::hunt {

/// The scene of a seed and a number: an arrangement of bodies, both methods, odd dt, inputs at odd times. One seed and
/// number give one scene on every machine, as long as kGrammar stays; every change of the grammar raises it.
sim::SceneDef random_scene(std::uint64_t seed, std::uint64_t number);

/// The version of the grammar, named in every finding.
inline constexpr std::uint32_t kGrammar = 2;

/// Limits of a scene. Small scenes are judged by the thousand, and hold what large ones do.
inline constexpr std::size_t kBodiesMost = 14;
inline constexpr std::uint64_t kStepsMost = 120;

}  // namespace tumble::hunt
