#pragma once

#include "tumble/sim/scene.h"

/// The bounds of the laws; docs/hunting.md gives the reasons.
namespace tumble::hunt {

/// A bound of each method: `thesis` promises less.
struct ByMethod {
  double thesis, layered;
  [[nodiscard]] double of(sim::Method method) const { return method == sim::Method::kThesis ? thesis : layered; }
};

inline constexpr double kEnergyPart = 1e-3;     ///< of the largest kinetic energy so far
inline constexpr double kPlaceError = 2e-3;     ///< m, by which errors of place may lift every body
inline constexpr double kBeginApart = 1e-3;     ///< m; boxes that begin deeper in one another are parted first
inline constexpr double kPartSlack = 5e-4;      ///< m of an overlap that method layered leaves, or
inline constexpr double kPartSlackPart = 1e-2;  ///< of the thinnest edge, where that is less
inline constexpr double kPartSpeed = 1;         ///< m/s, at which method layered parts at most
inline constexpr double kPartedSpeed = 1e-6;    ///< m/s, of boxes that begin at rest inside one another
inline constexpr double kPartedCentre = 1e-9;   ///< m a step, of their common centre
/// Of what a step is to take off an overlap: half where two ways out are equal, less what boxes turn.
inline constexpr double kPartedLeast = 0.4;
inline constexpr double kPartedSurely = 5e-3;  ///< m; shallower overlaps get few sweeps (docs/step.md)
inline constexpr double kPartedError = 1e-6;   ///< m
inline constexpr double kAngularPart = 0.05;   ///< of the angular momenta of the bodies, each by itself
inline constexpr double kTurnMost = 1;         ///< rad that a body that is hit may turn in a step
inline constexpr double kPartedDepth = 4e-4;   ///< m; boxes that begin a step deeper in one another are parted
inline constexpr double kPartedPart = 0.015;   ///< of the least half extent, where that is less
inline constexpr double kConePart = 0.25;      ///< of the impulse along the normal, of a steady contact
inline constexpr double kConeLoad = 0.5;       ///< of a body's weight, that a steady contact carries at least
/// Of a friction impulse, what it takes off the normal impulse of its corner at most: a body turns about an axis like
/// m r²/3 or more, r from the axis to a corner, and 3 s c / (1 + 3 c²) has its maximum 3/4 over all directions.
inline constexpr double kFrictionLifts = 0.75;
inline constexpr double kRemembered = 4;               ///< m/s, that a remembered impulse may give (docs/step.md)
inline constexpr ByMethod kOverlapPart = {0.5, 0.25};  ///< of the thinnest edge
inline constexpr double kOverlapLeast = 2e-3;          ///< m
inline constexpr double kOverlapRatio = 1000;          ///< of the masses of bodies that touch
inline constexpr double kSubstepMost = 1.0 / 240;      ///< s, of method layered
inline constexpr double kStandMargin = 0.1;            ///< of the width of the face on which a stack stands
inline constexpr double kStandRatio = 10;              ///< of two masses in a stack
inline constexpr double kStandDrift = 1e-3;            ///< m
inline constexpr double kUnitOfFloats = 1e-5;          ///< by which the square of a quaternion of floats may be off 1
inline constexpr double kRoundingOfFloats = 4e-6;      ///< relative: some tens of roundings in a step
inline constexpr double kTurnPart = 1e-3;              ///< of the angle turned
inline constexpr double kTurnBoundMost = 1;            ///< rad; a bound beyond says nothing

}  // namespace tumble::hunt
