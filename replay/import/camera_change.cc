#include "replay/import/camera_change.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "src/base/text.h"
#include "src/model/camera.h"

namespace tumble::replay {
namespace {

Error wrong(const std::string& key, const std::string& value, const std::string& wanted) {
  return bad_input("camera " + key + ": " + found_wanted(in_quotes(value), wanted));
}

Status set_place(const std::string& key, const std::string& value, std::optional<sim::Vec3>& place) {
  const std::vector<double> numbers = numbers_of(value);
  if (numbers.size() != 3) return wrong(key, value, "three coordinates, as in 3,-8,4");
  place = sim::Vec3(numbers[0], numbers[1], numbers[2]);
  return {};
}

Status set_number(const std::string& key, const std::string& value, std::optional<double>& out) {
  const std::vector<double> numbers = numbers_of(value);
  if (numbers.size() != 1) return wrong(key, value, "a number");
  out = numbers[0];
  return {};
}

}  // namespace

std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* end = at + text.size();
  const auto skip_spaces = [&] { at = std::find_if(at, end, [](char c) { return c != ' '; }); };
  for (bool wants_more = false;;) {
    skip_spaces();
    if (at == end) return wants_more ? std::vector<double>() : numbers;
    double value = 0;
    const auto [stop, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value)) return {};
    if (stop != end && *stop != ' ' && *stop != ',') return {};
    numbers.push_back(value);
    at = stop;
    skip_spaces();
    wants_more = at != end && *at == ',';
    if (wants_more) ++at;
  }
}

Status CameraChange::set(const std::string& key, const std::string& value) {
  if (key == "position") return set_place(key, value, position);
  if (key == "target") return set_place(key, value, target);
  if (key == "fov") return set_number(key, value, fov);
  if (key == "focus") return set_number(key, value, focus);
  if (key == "blur") return set_number(key, value, blur);
  return bad_input("camera: " + found_wanted(in_quotes(key), "position, target, fov, focus or blur"));
}

Result<sim::Camera> CameraChange::applied_to(sim::Camera camera) const {
  const bool moves = position || target;
  if (!moves && !fov && !focus && !blur) return camera;
  camera.position = position.value_or(camera.position);
  camera.target = target.value_or(camera.target);
  camera.fov = fov.value_or(camera.fov);
  camera.focus = focus.value_or(moves ? sim::focus_on_target(camera) : camera.focus);
  camera.blur = blur.value_or(camera.blur);
  if (Status ok = sim::check_camera(camera); !ok.ok()) return ok.error();
  return camera;
}

bool take_number(const std::string& text, double& out) {
  const std::vector<double> numbers = numbers_of(text);
  if (numbers.size() != 1) return false;
  out = numbers[0];
  return true;
}

bool take_vector(const std::string& text, sim::Vec3& out) {
  const std::vector<double> numbers = numbers_of(text);
  if (numbers.size() != 3) return false;
  out = {numbers[0], numbers[1], numbers[2]};
  return true;
}

}  // namespace tumble::replay
