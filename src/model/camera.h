#pragma once

#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

/// The limits of a camera, wherever one comes from: a scene, a table, an argument.
namespace tumble::sim {

inline constexpr double kViewMax = 1e6;    ///< m, each coordinate of position and target
inline constexpr double kFovMin = 1;       ///< degrees
inline constexpr double kFovMax = 170;     ///< degrees
inline constexpr double kFocusMin = 1e-3;  ///< m
inline constexpr double kFocusMax = 1e6;   ///< m
inline constexpr double kBlurMax = 100;

/// Errors (kBadInput): a value beyond the limits, "camera fov: found 500, wanted a number from 1 to 170"; a camera that
/// stands in its target.
Status check_camera(const Camera& camera);

/// The focus of a camera that none is given for, m: the distance to its target, within the limits.
double focus_on_target(const Camera& camera);

}  // namespace tumble::sim
