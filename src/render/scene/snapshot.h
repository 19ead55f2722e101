#pragma once

#include <cstdint>
#include <vector>

#include "src/math/rotation.h"
#include "src/math/vec.h"
#include "src/model/scene.h"

/// Everything a picture is made of, as plain data. The renderer knows no more of a simulation than this.
namespace tumble::render {

/// A colour in linear light, 0 … 1 a channel.
struct Colour {
  float r = 1, g = 1, b = 1;
};

/// A box as it is to be seen.
struct BoxLook {
  std::uint64_t id = 0;               ///< picks the variation of its material; nothing else
  sim::Vec3 centre = {0, 0, 0};       ///< m, world
  sim::Quat orientation;              ///< unit length
  sim::Vec3 half_extent = {1, 1, 1};  ///< m, own axes
  sim::Vec3 velocity = {0, 0, 0};     ///< m/s; motion blur only
  sim::Vec3 spin = {0, 0, 0};         ///< rad/s, world axes; motion blur only
  sim::Texture texture = sim::Texture::kCrate;
  Colour tint;  ///< multiplies the texture
};

/// A small box of plain colour that is drawn over everything and casts no shadow: a contact point, part of an arrow.
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

/// What was to be seen at a part (0 … 1) of the `dt` seconds from one state to the next: positions on straight lines,
/// orientations on the shorter arc. Boxes that only `after` has fly there as they come out; those that only `before`
/// has are gone. Markers, camera and light are `after`'s.
Snapshot between(const Snapshot& before, const Snapshot& after, double part, double dt);

}  // namespace tumble::render
