#include "src/world/float_environment.h"

#include <cfenv>
#include <limits>

namespace tumble::sim {

Status check_float_environment() {
  // volatile: the machine's arithmetic is asked, not the compiler's.
  volatile double one = 1.0;
  volatile double half_ulp = 0x1p-53;
  volatile double odd = 1.0 + 0x1p-52;
  volatile double smallest = std::numeric_limits<double>::min();
  const bool tie_down = one + half_ulp == 1.0;
  const bool tie_up = odd + half_ulp == 1.0 + 0x1p-51;
  const bool negative = -one - half_ulp == -1.0;
  if (!tie_down || !tie_up || !negative) {
    return cannot_finish(
        "floating-point environment: doubles do not round to nearest even; restore the default rounding mode "
        "(fesetround(FE_TONEAREST)) first");
  }
  volatile double subnormal = smallest * 0.5;
  if (subnormal == 0 || subnormal * 2 != smallest) {
    return cannot_finish(
        "floating-point environment: subnormal numbers are flushed to zero, which some library built with -ffast-math "
        "has switched on; unload it or clear FTZ and DAZ in MXCSR first");
  }
  return {};
}

void restore_float_environment() { std::fesetenv(FE_DFL_ENV); }

}  // namespace tumble::sim
