#include "src/render/scene/pick.h"

#include <cmath>
#include <limits>
#include <utility>

namespace tumble::render {
namespace {

using sim::Vec3;

// Where the ray enters the box, m along it. Slabs of the box's own axes, one after the other.
std::optional<double> entry_of(const BoxLook& box, const Ray& ray) {
  const sim::Axes axes = sim::axes_of(box.orientation);
  const Vec3 from = sim::to_body(axes, Vec3(ray.from - box.centre));
  const Vec3 along = sim::to_body(axes, ray.direction);
  double enter = -std::numeric_limits<double>::infinity(), leave = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (along[k] == 0) {
      if (std::fabs(from[k]) > box.half_extent[k]) return std::nullopt;
      continue;
    }
    double near = (-box.half_extent[k] - from[k]) / along[k], far = (box.half_extent[k] - from[k]) / along[k];
    if (near > far) std::swap(near, far);
    enter = std::max(enter, near);
    leave = std::min(leave, far);
  }
  if (enter > leave || enter <= 0) return std::nullopt;
  return enter;
}

}  // namespace

Ray ray_through(const View& view, double x, double y) {
  const Vec3 gaze =
      view.forward + view.right * ((2 * x - 1) * view.tangent_x) + view.up * ((1 - 2 * y) * view.tangent_y);
  return {view.eye, Vec3(gaze / sim::length(gaze))};
}

std::optional<Hit> pick(const Snapshot& snapshot, const Ray& ray) {
  std::optional<Hit> nearest;
  for (const BoxLook& box : snapshot.boxes) {
    const std::optional<double> entry = entry_of(box, ray);
    if (!entry || (nearest && nearest->distance <= *entry)) continue;
    nearest = Hit{box.id, Vec3(ray.from + ray.direction * *entry), *entry};
  }
  return nearest;
}

}  // namespace tumble::render
