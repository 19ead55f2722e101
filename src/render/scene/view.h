#pragma once

#include <array>

#include "tumble/render/snapshot.h"
#include "tumble/sim/vec.h"

/// The views of camera and light, computed in doubles. The simulation reads none of them.
namespace tumble::render {

inline constexpr double kDegree = 3.14159265358979323846 / 180;  ///< rad

/// A 4 × 4 matrix in the column-major order of GL: clip = M · (x, y, z, 1).
using Matrix = std::array<double, 16>;
std::array<float, 16> to_floats(const Matrix& matrix);

struct View {
  sim::Vec3 eye = {0, 0, 0};                                         ///< m, world
  sim::Vec3 right = {1, 0, 0}, up = {0, 0, 1}, forward = {0, 1, 0};  ///< unit, world
  double tangent_x = 1, tangent_y = 1;  ///< of half the angle of view, horizontal and vertical
  double near = 0.1, far = 1000;        ///< m, along forward
  Matrix clip_from_world{};

  /// Distance in m along `forward`; negative behind the eye.
  [[nodiscard]] double depth_of(const sim::Vec3& p_W) const { return sim::dot(p_W - eye, forward); }
};

/// The view of the camera. width, height: of the picture, in pixels.
View camera_view(const sim::Camera& camera, int width, int height);

/// The view of the light, from its position to its target. Wide enough for all boxes up to a limit; boxes beyond the
/// limit cast no shadow. The width grows in coarse steps, so that shadows do not change in size from frame to frame.
View light_view(const Snapshot& snapshot);

}  // namespace tumble::render
