#pragma once

namespace tumble::sim {

struct SinCos {
  double sin;
  double cos;
};

/// Sine and cosine of an angle in degrees, the same bits on every machine: libm's differ. For turning a scene's angles
/// into orientations; the stepper itself needs no trigonometry.
///
/// The angle is reduced exactly, then a polynomial in fixed order gives an error below 2⁻⁵² (tests/sim/trig_test.cc
/// measures it). Multiples of 30° and 45° are the correctly rounded values; sin(−a) = −sin(a), cos(−a) = cos(a),
/// sin(90 − a) = cos(a) to the bit wherever 90 − a is exact. Precondition: finite.
SinCos sin_cos_degrees(double degrees);

}  // namespace tumble::sim
