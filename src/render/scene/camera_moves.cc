#include "src/render/scene/camera_moves.h"

#include <algorithm>
#include <cmath>

#include "src/render/scene/view.h"

namespace tumble::render {
namespace {

using sim::Vec3;

constexpr double kSteepest = 88;                   // degrees; straight up or down, a picture has no horizon to turn
constexpr double kNearest = 0.1, kFarthest = 1e4;  // m
constexpr double kAboveGround = 0.05;              // m

double distance_of(const sim::Camera& camera) {
  return std::max(sim::length(camera.target - camera.position), kNearest);
}

}  // namespace

void orbit(sim::Camera& camera, double right_degrees, double up_degrees, bool ground) {
  const double distance = distance_of(camera);
  const Vec3 out = camera.position - camera.target;
  const double azimuth = std::atan2(out.y(), out.x()) + right_degrees * kDegree;
  double lowest = -kSteepest * kDegree;
  if (ground) lowest = std::asin(std::clamp((kAboveGround - camera.target.z()) / distance, -1.0, 1.0));
  const double wanted = std::asin(std::clamp(out.z() / distance, -1.0, 1.0)) + up_degrees * kDegree;
  const double elevation = std::clamp(wanted, std::min(lowest, kSteepest * kDegree), kSteepest * kDegree);
  const double flat = std::cos(elevation) * distance;
  camera.position =
      camera.target + Vec3(flat * std::cos(azimuth), flat * std::sin(azimuth), std::sin(elevation) * distance);
}

void pan(sim::Camera& camera, double right, double up) {
  const View view = camera_view(camera, 1, 1);
  const double height = 2 * view.tangent_y * distance_of(camera);
  shift(camera, Vec3(view.right * (right * height) + view.up * (up * height)));
}

void zoom(sim::Camera& camera, double factor) {
  const double before = distance_of(camera);
  const double after = std::clamp(before * factor, kNearest, kFarthest);
  camera.position = camera.target + (camera.position - camera.target) * (after / before);
  camera.focus *= after / before;
}

void shift(sim::Camera& camera, const Vec3& shift) {
  camera.position += shift;
  camera.target += shift;
}

}  // namespace tumble::render
