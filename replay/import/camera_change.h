#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

namespace tumble::replay {

/// The finite numbers of "0 0 -9.81", with spaces or one comma between; empty for any other text.
std::vector<double> numbers_of(const std::string& text);
/// One number; three. False for any other text.
bool take_number(const std::string& text, double& out);
bool take_vector(const std::string& text, sim::Vec3& out);

/// Values that replace those of a camera, from the lines "camera.position: 3 -8 4" of a table or from arguments.
struct CameraChange {
  std::optional<sim::Vec3> position, target;  ///< m
  std::optional<double> fov;                  ///< degrees
  std::optional<double> focus;                ///< m
  std::optional<double> blur;

  /// key: position, target, fov, focus or blur. value: one number, or three with spaces or commas between, in the
  /// units of the caller. Errors (kBadInput): another key, another value; the message says what was found and wanted.
  Status set(const std::string& key, const std::string& value);

  /// The camera with these values. Its focus is the distance to the target unless given here or, where neither position
  /// nor target is, before. Errors (kBadInput): those of sim::check_camera(); "camera KEY: …".
  [[nodiscard]] Result<sim::Camera> applied_to(sim::Camera camera) const;
};

}  // namespace tumble::replay
