#pragma once

#include <cstddef>
#include <vector>

#include "tumble/sim/transform.h"
#include "tumble/sim/world.h"

namespace tumble::test {

using sim::IdMap;
using sim::ids_under;
using sim::image_of;
using sim::Transform;

/// Mirrored in x, in y, x and y swapped, shifted by (1024, −512.5, 0), ids permuted; and all of it at once.
const std::vector<Transform>& all_transforms();

/// The scene with the values that create_world and the inputs would round, rounded: state 0 is then what it says.
sim::SceneDef resolved(const sim::SceneDef& scene);

/// How many bodies of `image` are not, in every bit of position, orientation, velocity, spin, frozen and time at low
/// energy, the image of their original; bodies missing on one side count.
std::size_t differing_bodies(const sim::World& original, const sim::World& image, const Transform& transform,
                             const IdMap& ids);

}  // namespace tumble::test
