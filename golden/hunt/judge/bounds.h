#pragma once

#include "tumble/sim/scene.h"

/// The bounds of the laws; docs/hunting.md gives the reasons.
namespace tumble::hunt {

/// A bound of each method: `thesis` promises less.
struct ByMethod {
  double thesis, layered;
  [[nodiscard]] double of(sim::Method method) const { return method == sim::Method::kThesis ? thesis : layered; }
};

inline constexpr double kEnergyPart = 1e-3;            ///< of the largest kinetic energy so far
inline constexpr ByMethod kLift = {20e-3, 4e-3};       ///< m, by which errors of place may lift every body
inline constexpr double kAngularPart = 0.05;           ///< of the angular momenta of the bodies, each by itself
inline constexpr double kPartedDepth = 4e-4;           ///< m; boxes that begin a step deeper in one another are parted
inline constexpr double kPartedPart = 0.015;           ///< of the least half extent, where that is less
inline constexpr double kConePart = 0.25;              ///< of the impulse along the normal
inline constexpr ByMethod kOverlapPart = {0.5, 0.25};  ///< of the thinnest edge
inline constexpr double kOverlapLeast = 2e-3;          ///< m
inline constexpr double kStandMargin = 0.1;            ///< of the width of the face on which a stack stands
inline constexpr double kStandRatio = 10;              ///< of two masses in a stack
inline constexpr double kStandDrift = 1e-3;            ///< m
inline constexpr double kTurnPart = 1e-3;              ///< of the angle turned

}  // namespace tumble::hunt
