#include "src/math/trig.h"

#include <cmath>

#include "src/base/check.h"

namespace tumble::sim {
namespace {

// Taylor's coefficients: up to 45° the terms left out are below 2⁻⁵⁸ of the sum.
double sine_polynomial(double x) {
  const double xx = x * x;
  double sum = 1.0 / 355687428096000.0;  // 1/17!
  sum = sum * xx - 1.0 / 1307674368000.0;
  sum = sum * xx + 1.0 / 6227020800.0;
  sum = sum * xx - 1.0 / 39916800.0;
  sum = sum * xx + 1.0 / 362880.0;
  sum = sum * xx - 1.0 / 5040.0;
  sum = sum * xx + 1.0 / 120.0;
  sum = sum * xx - 1.0 / 6.0;
  return x + (x * xx) * sum;
}

double cosine_polynomial(double x) {
  const double xx = x * x;
  double sum = -1.0 / 6402373705728000.0;  // 1/18!
  sum = sum * xx + 1.0 / 20922789888000.0;
  sum = sum * xx - 1.0 / 87178291200.0;
  sum = sum * xx + 1.0 / 479001600.0;
  sum = sum * xx - 1.0 / 3628800.0;
  sum = sum * xx + 1.0 / 40320.0;
  sum = sum * xx - 1.0 / 720.0;
  sum = sum * xx + 1.0 / 24.0;
  return 1.0 - (0.5 * xx - (xx * xx) * sum);
}

// 0 … 45 degrees.
SinCos sin_cos_first_octant(double degrees) {
  if (degrees == 45) return {std::sqrt(0.5), std::sqrt(0.5)};
  if (degrees == 30) return {0.5, std::sqrt(0.75)};
  const double radians = degrees * 0.017453292519943295;  // π/180
  return {sine_polynomial(radians), cosine_polynomial(radians)};
}

}  // namespace

SinCos sin_cos_degrees(double degrees) {
  SIM_DCHECK(std::isfinite(degrees), degrees);
  const double turn = std::fmod(std::fabs(degrees), 360.0);  // exact
  const double quarters = std::floor(turn / 90.0);
  double rest = turn - 90.0 * quarters;  // exact, 0 … 90
  SinCos value = rest <= 45 ? sin_cos_first_octant(rest) : sin_cos_first_octant(90.0 - rest);
  if (rest > 45) value = {value.cos, value.sin};
  if (quarters == 1) value = {value.cos, -value.sin};
  if (quarters == 2) value = {-value.sin, -value.cos};
  if (quarters == 3) value = {-value.cos, value.sin};
  if (degrees < 0) value.sin = -value.sin;
  return {value.sin + 0.0, value.cos + 0.0};
}

}  // namespace tumble::sim
