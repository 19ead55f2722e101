#pragma once

#include <cstdint>
#include <optional>

#include "src/render/scene/view.h"
#include "tumble/render/snapshot.h"
#include "tumble/sim/vec.h"

/// The body under a pixel.
namespace tumble::render {

struct Ray {
  sim::Vec3 from = {0, 0, 0};       ///< m, world
  sim::Vec3 direction = {0, 1, 0};  ///< unit
};

/// The ray of sight through a point of the picture, in shares of its width and height from the upper left corner.
Ray ray_through(const View& view, double x, double y);

struct Hit {
  std::uint64_t id = 0;
  sim::Vec3 point = {0, 0, 0};  ///< m, world
  double distance = 0;          ///< m, from the ray's start
};

/// The nearest box that the ray enters; none where it meets no box. A box around the ray's start does not count.
std::optional<Hit> pick(const Snapshot& snapshot, const Ray& ray);

}  // namespace tumble::render
