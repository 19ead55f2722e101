#include "replay/import/camera_change.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <vector>

#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr double kPlaceMax = 1e6;  // m; the limits of [camera] in a scene
constexpr double kFovMin = 1, kFovMax = 170;
constexpr double kFocusMin = 0.001;
constexpr double kBlurMax = 100;

/// The numbers of a text with spaces or commas between; none at all if anything else is in it.
std::vector<double> read_numbers(const std::string& text) {
  std::vector<double> numbers;
  for (const char *at = text.data(), *end = at + text.size(); at != end;) {
    if (*at == ' ' || *at == ',') {
      ++at;
      continue;
    }
    double value = 0;
    const auto [stop, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value)) return {};
    numbers.push_back(value);
    at = stop;
  }
  return numbers;
}

Error wrong(const std::string& key, const std::string& value, const std::string& wanted) {
  return bad_input("camera " + key + ": " + found_wanted(in_quotes(value), wanted));
}

Status set_place(const std::string& key, const std::string& value, std::optional<sim::Vec3>& place) {
  const std::vector<double> numbers = read_numbers(value);
  if (numbers.size() == 3) place = sim::Vec3(numbers[0], numbers[1], numbers[2]);
  const bool taken = numbers.size() == 3 && place->cwiseAbs().maxCoeff() <= kPlaceMax;
  return taken ? Status() : wrong(key, value, "three coordinates up to 1e6 m, as in 3,-8,4");
}

Status set_number(const std::string& key, const std::string& value, double low, double high,
                  std::optional<double>& out) {
  const std::vector<double> numbers = read_numbers(value);
  if (numbers.size() == 1 && numbers[0] >= low && numbers[0] <= high) {
    out = numbers[0];
    return {};
  }
  return wrong(key, value, "a number from " + number_text(low) + " to " + number_text(high));
}

}  // namespace

Status CameraChange::set(const std::string& key, const std::string& value) {
  if (key == "position") return set_place(key, value, position);
  if (key == "target") return set_place(key, value, target);
  if (key == "fov") return set_number(key, value, kFovMin, kFovMax, fov);
  if (key == "focus") return set_number(key, value, kFocusMin, kPlaceMax, focus);
  if (key == "blur") return set_number(key, value, 0, kBlurMax, blur);
  return bad_input("camera: " + found_wanted(in_quotes(key), "position, target, fov, focus or blur"));
}

Result<sim::Camera> CameraChange::applied_to(sim::Camera camera) const {
  const bool moves = position || target;
  camera.position = position.value_or(camera.position);
  camera.target = target.value_or(camera.target);
  const double distance = sim::length(camera.target - camera.position);
  if (moves && distance == 0) {
    return bad_input(
        "camera: found its position at its target, wanted two points, or there is no direction to look in");
  }
  camera.fov = fov.value_or(camera.fov);
  camera.focus = focus.value_or(moves ? distance : camera.focus);
  camera.blur = blur.value_or(camera.blur);
  return camera;
}

}  // namespace tumble::replay
