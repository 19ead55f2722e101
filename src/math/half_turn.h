#pragma once

#include <cmath>

#include "src/math/turn_series.h"
#include "tumble/sim/rotation.h"

namespace tumble::sim {

/// Whether a turn is so small that a Cayley turn is good enough. h: the axis times half the angle.
inline bool turns_slowly(const Vec3& h) { return dot(h, h) <= kSlowHalfSquared; }

/// The quaternion of a turn by any angle, not normalised. h: the axis times half the angle. A small turn takes the
/// angle for its tangent, (1, h). A larger one takes the tangent by the quotient N / D of turn_series.h, as (D, h N),
/// after whole turns are taken off; so no sine is needed and no pole is met. Odd in h, hence exact under mirrors.
inline Quat half_turn(const Vec3& h) {
  const double squared = dot(h, h);
  if (squared <= kSlowHalfSquared) return {1, h.x(), h.y(), h.z()};
  const double half = std::sqrt(squared);
  const double turns = (half * kInversePi + kWholeMagic) - kWholeMagic;
  const double rest = (half - turns * kPiHigh) - turns * kPiLow, x = rest * rest;
  const double* const n = kTangentN;
  const double* const d = kTangentD;
  const double sine = (((n[0] * x + n[1]) * x + n[2]) * x + n[3]) * x + n[4];
  const double cosine = ((((d[0] * x + d[1]) * x + d[2]) * x + d[3]) * x + d[4]) * x + d[5];
  const double part = sine * (rest / half);
  return {cosine, h.x() * part, h.y() * part, h.z() * part};
}

/// q turned about a world axis. h_W: the axis times half the angle.
inline Quat turned(const Quat& q, const Vec3& h_W) { return normalised(product(half_turn(h_W), q)); }

}  // namespace tumble::sim
