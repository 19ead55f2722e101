#pragma once

#include <array>

#include "src/math/vec.h"
#include "src/render/scene/snapshot.h"

/// Where the camera and the light look. Computed in doubles; the simulation never sees any of it.
namespace tumble::render {

/// 4 × 4, column-major, as GL takes it: clip = M · (x, y, z, 1).
using Matrix = std::array<double, 16>;
std::array<float, 16> to_floats(const Matrix& matrix);

struct View {
  sim::Vec3 eye = {0, 0, 0};                                         ///< m, world
  sim::Vec3 right = {1, 0, 0}, up = {0, 0, 1}, forward = {0, 1, 0};  ///< unit, world
  double tangent_x = 1, tangent_y = 1;                               ///< of half the angle of view, across and upwards
  double near = 0.1, far = 1000;                                     ///< m, along forward
  Matrix clip_from_world{};

  /// m along forward; negative behind.
  [[nodiscard]] double depth_of(const sim::Vec3& p_W) const { return sim::dot(p_W - eye, forward); }
};

/// The camera's. width, height: of the picture, pixels.
View camera_view(const sim::Camera& camera, int width, int height);

/// The light's: from its position to its target, as wide as the boxes are spread, up to a limit; beyond it nothing
/// casts a shadow. The width grows in coarse steps, so that the shadow map of a movie does not breathe.
View light_view(const Snapshot& snapshot);

}  // namespace tumble::render
