#include "src/model/camera.h"

#include <algorithm>
#include <string>

#include "src/base/text.h"
#include "tumble/sim/vec.h"

namespace tumble::sim {
namespace {

Status check_place(const char* key, const Vec3& place) {
  if (place.cwiseAbs().maxCoeff() <= kViewMax) return {};
  const std::string found = exact(place.x()) + ", " + exact(place.y()) + ", " + exact(place.z());
  return bad_input(std::string("camera ") + key + ": " + found_wanted(found, "three coordinates up to 1e6 m"));
}

Status check_number(const char* key, double value, double low, double high) {
  if (value >= low && value <= high) return {};
  return bad_input(std::string("camera ") + key + ": " +
                   found_wanted(exact(value), "a number from " + number_text(low) + " to " + number_text(high)));
}

}  // namespace

Status check_camera(const Camera& camera) {
  if (Status ok = check_place("position", camera.position); !ok.ok()) return ok;
  if (Status ok = check_place("target", camera.target); !ok.ok()) return ok;
  if (camera.position == camera.target) {
    return bad_input("camera position: found the target's, wanted two points, or there is no direction to look in");
  }
  if (Status ok = check_number("fov", camera.fov, kFovMin, kFovMax); !ok.ok()) return ok;
  if (Status ok = check_number("focus", camera.focus, kFocusMin, kFocusMax); !ok.ok()) return ok;
  return check_number("blur", camera.blur, 0, kBlurMax);
}

double focus_on_target(const Camera& camera) {
  return std::clamp(length(camera.target - camera.position), kFocusMin, kFocusMax);
}

}  // namespace tumble::sim
