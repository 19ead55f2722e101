#pragma once

namespace tumble::sim {

struct SinCos {
  double sin;
  double cos;
};

/// Sine and cosine of an angle in degrees, with one result on every machine; those of libm differ. Scenes need both to
/// turn angles into orientations; the stepper needs no trigonometry.
///
/// The angle is reduced exactly, and a polynomial in fixed order gives an error below 2⁻⁵² (tests/sim/trig_test.cc
/// measures the error). Multiples of 30° and 45° are the correctly rounded values; sin(−a) = −sin(a), cos(−a) = cos(a),
/// sin(90 − a) = cos(a) to the bit wherever 90 − a is exact. Precondition: finite.
SinCos sin_cos_degrees(double degrees);

}  // namespace tumble::sim
