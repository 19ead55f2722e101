#include "src/render/scene/view.h"

#include <algorithm>
#include <cmath>

namespace tumble::render {
namespace {

using sim::Vec3;

constexpr double kLightTangentMin = 0.05;
constexpr double kLightTangentMax = 1.2;    // a cone of 100 degrees: beyond it the map is too coarse to be of use
constexpr double kLightTangentStep = 1.25;  // of one width to the next

View look_at(const Vec3& eye, const Vec3& target) {
  View view;
  view.eye = eye;
  const Vec3 gaze = target - eye;
  const double distance = sim::length(gaze);
  view.forward = distance > 0 ? Vec3(gaze / distance) : Vec3(0, 1, 0);
  // Straight down or up, y is up on the picture, as on a map.
  const bool is_vertical = std::fabs(view.forward.z()) > 0.9999;
  const Vec3 side = sim::cross(view.forward, is_vertical ? Vec3(0, 1, 0) : Vec3(0, 0, 1));
  view.right = side / sim::length(side);
  view.up = sim::cross(view.right, view.forward);
  return view;
}

// From right, up, forward, eye, tangents, near and far.
void set_matrix(View& view) {
  const double depth_scale = (view.far + view.near) / (view.far - view.near);
  const double depth_offset = -2 * view.far * view.near / (view.far - view.near);
  const std::array<Vec3, 4> rows = {view.right / view.tangent_x, view.up / view.tangent_y, view.forward * depth_scale,
                                    view.forward};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      view.clip_from_world[column * 4 + row] = rows[row][static_cast<Eigen::Index>(column)];
    }
    view.clip_from_world[12 + row] = -sim::dot(rows[row], view.eye) + (row == 2 ? depth_offset : 0);
  }
}

}  // namespace

std::array<float, 16> to_floats(const Matrix& matrix) {
  std::array<float, 16> floats{};
  std::ranges::transform(matrix, floats.begin(), [](double x) { return static_cast<float>(x); });
  return floats;
}

View camera_view(const sim::Camera& camera, int width, int height) {
  View view = look_at(camera.position, camera.target);
  view.tangent_y = std::tan(camera.fov * kDegree / 2);
  view.tangent_x = view.tangent_y * width / height;
  const double distance = std::max(sim::length(camera.target - camera.position), 1e-3);
  view.near = std::min(0.1, distance / 50);
  view.far = std::max(2000.0, distance * 40);
  set_matrix(view);
  return view;
}

View light_view(const Snapshot& snapshot) {
  View view = look_at(snapshot.light.position, snapshot.light.target);
  double tangent = kLightTangentMin;
  for (const BoxLook& box : snapshot.boxes) {
    const double radius = sim::length(box.half_extent);
    const double depth = view.depth_of(box.centre) - radius;
    if (depth <= 0) continue;
    const Vec3 offset = box.centre - view.eye;
    const double reach = std::max(std::fabs(sim::dot(offset, view.right)), std::fabs(sim::dot(offset, view.up)));
    const double wanted = (reach + radius) / depth;
    if (wanted <= kLightTangentMax) tangent = std::max(tangent, wanted);
  }
  double width = kLightTangentMin;
  while (width < tangent) width *= kLightTangentStep;
  view.tangent_x = view.tangent_y = width;
  const double distance = std::max(sim::length(snapshot.light.target - snapshot.light.position), 1e-3);
  view.near = distance / 50;
  view.far = distance * 10;
  set_matrix(view);
  return view;
}

}  // namespace tumble::render
