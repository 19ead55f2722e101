#pragma once

#include <cstdint>
#include <optional>

#include "tumble/render/renderer.h"
#include "tumble/sim/scene.h"

namespace tumble::tools {

/// What the left button does.
enum class Tool { kThrow, kPush, kRemove, kWake, kFollow };
inline constexpr int kToolCount = 5;
inline constexpr const char* kToolNames[kToolCount] = {"throw", "push", "remove", "wake", "follow"};

/// The choices of the one who plays, besides inputs. None of them changes a session.
struct ViewState {
  sim::Camera camera;
  render::Effects effects;
  int samples = 1;
  double scale = 1;                     ///< pixels of the picture over those of the window, each way
  std::optional<std::uint64_t> follow;  ///< a body

  Tool tool = Tool::kThrow;
  float edge = 0.8F;    ///< m, of a thrown box
  float density = 600;  ///< kg/m³
  float friction = 0.4F, restitution = 0.2F;
  int texture = 0;       ///< of sim::Texture
  float fastest = 40;    ///< m/s, of a throw that was held for kHoldSeconds
  float strongest = 10;  ///< m/s that a push held as long gives a body

  bool panel = true, keys = false;
  bool contacts = false, velocities = false, bounds = false, freezing = false;
};

inline constexpr double kBackSeconds = 10;  ///< of simulated time, that "back" goes back

/// The button is held this long for full speed. Speed grows evenly with time.
inline constexpr double kHoldSeconds = 1;
inline constexpr double kHoldLeast = 0.1;  ///< of full speed, for a click

/// The part of full speed that holding the button for `seconds` gives.
double held_part(double seconds);

}  // namespace tumble::tools
