#pragma once

namespace tumble::sim {

// The constants of half_turn.h for the files of src/kernels/lanes/lane_vector.h, which may include no header with
// functions.

/// A turn by at most 1/16 rad is one Cayley turn, which falls short by at most 0.033 %. Squared half of the turn.
inline constexpr double kSlowHalfSquared = 1.0 / 1024.0;

/// π = kPiHigh + kPiLow. kPiHigh has 40 bits, so its product with up to 4,096 is exact.
inline constexpr double kPiHigh = 0x1.921fb54442p+1;
inline constexpr double kPiLow = 0x1.a308d313198a3p-40;
inline constexpr double kInversePi = 0.3183098861837907;
inline constexpr double kWholeMagic = 6755399441055744.0;  ///< adding and subtracting it rounds to whole numbers

/// tan t = t N(t²) / D(t²): Lambert's continued fraction to its tenth level, the Padé approximant of the exponential.
/// Up to π/2 the angle is off by less than 2e-15. Coefficients from the highest power down.
inline constexpr double kTangentN[] = {55, -25740, 2837835, -91891800, 654729075};
inline constexpr double kTangentD[] = {-1, 1485, -315315, 18918900, -310134825, 654729075};

}  // namespace tumble::sim
