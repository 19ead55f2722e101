#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tumble/sim/rotation.h"
#include "tumble/sim/scene.h"
#include "tumble/sim/vec.h"

/// The content of a picture as plain data. The renderer reads nothing else of a simulation.
namespace tumble::render {

/// A colour in linear light, 0 … 1 per channel.
struct Colour {
  float r = 1, g = 1, b = 1;
};

struct Solid;  // src/render/scene/solid.h

/// The look of one body: a box, or another solid.
struct BoxLook {
  std::uint64_t id = 0;                          ///< selects the variation of the material; nothing else
  sim::Vec3 centre = {0, 0, 0};                  ///< m, world
  sim::Quat orientation;                         ///< unit length
  sim::Vec3 half_extent = {1, 1, 1};             ///< m, own axes; of the box around a solid
  std::shared_ptr<const Solid> solid = nullptr;  ///< null: the box. Bodies of one shape share it
  sim::Vec3 velocity = {0, 0, 0};                ///< m/s; motion blur only
  sim::Vec3 spin = {0, 0, 0};                    ///< rad/s, world axes; motion blur only
  sim::Texture texture = sim::Texture::kCrate;
  Colour tint;  ///< multiplies the texture
};

/// A small box of plain colour, for contact points and arrows. Drawn over everything, without a shadow.
struct Marker {
  sim::Vec3 centre = {0, 0, 0};  ///< m, world
  sim::Quat orientation;
  sim::Vec3 half_extent = {1, 1, 1};  ///< m
  Colour colour;
};

struct Snapshot {
  std::vector<BoxLook> boxes;
  std::vector<Marker> markers;
  bool ground = true;  ///< the plane z = 0
  sim::Camera camera;
  sim::Light light;
};

/// The snapshot at a fraction `part` (0 … 1) of the `dt` seconds between two states. Positions move on straight lines,
/// orientations on the shorter arc. A box that only `after` has is moved back along its velocity; a box that only
/// `before` has is left out. Markers, camera and light are those of `after`.
Snapshot between(const Snapshot& before, const Snapshot& after, double part, double dt);

}  // namespace tumble::render
