#include "src/math/trig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tumble::sim {
namespace {

TEST(Trig, QuarterTurnsAreExact) {
  const double sines[] = {0, 1, 0, -1};
  const double cosines[] = {1, 0, -1, 0};
  for (int quarter = -8; quarter <= 8; ++quarter) {
    const SinCos value = sin_cos_degrees(90.0 * quarter);
    const int i = ((quarter % 4) + 4) % 4;
    EXPECT_EQ(value.sin, sines[i]) << quarter;
    EXPECT_EQ(value.cos, cosines[i]) << quarter;
    EXPECT_FALSE(std::signbit(value.sin) && value.sin == 0) << quarter;
    EXPECT_FALSE(std::signbit(value.cos) && value.cos == 0) << quarter;
  }
}

TEST(Trig, ThirtyAndFortyFiveAreCorrectlyRounded) {
  EXPECT_EQ(sin_cos_degrees(30).sin, 0.5);
  EXPECT_EQ(sin_cos_degrees(30).cos, std::sqrt(0.75));
  EXPECT_EQ(sin_cos_degrees(60).sin, std::sqrt(0.75));
  EXPECT_EQ(sin_cos_degrees(60).cos, 0.5);
  EXPECT_EQ(sin_cos_degrees(45).sin, std::sqrt(0.5));
  EXPECT_EQ(sin_cos_degrees(45).cos, std::sqrt(0.5));
  EXPECT_EQ(sin_cos_degrees(135).cos, -std::sqrt(0.5));
  EXPECT_EQ(sin_cos_degrees(-150).sin, -0.5);
}

// libm is right to well below the tolerance wherever it is any good; what its last bit is must not matter here.
TEST(Trig, AgreesWithTheLibraryToTwoToTheMinus52) {
  double worst = 0;
  for (int i = -400000; i <= 400000; ++i) {
    const double degrees = i * 0.0031;
    const SinCos value = sin_cos_degrees(degrees);
    const long double radians = static_cast<long double>(degrees) * 3.14159265358979323846264338327950288L / 180;
    worst = std::max(worst, std::fabs(static_cast<double>(value.sin - std::sin(radians))));
    worst = std::max(worst, std::fabs(static_cast<double>(value.cos - std::cos(radians))));
  }
  EXPECT_LT(worst, 0x1p-52);
}

TEST(Trig, IsOddAndEvenToTheBit) {
  for (int i = 0; i <= 10000; ++i) {
    const double degrees = i * 0.0371;
    EXPECT_EQ(sin_cos_degrees(-degrees).sin, -sin_cos_degrees(degrees).sin + 0.0);
    EXPECT_EQ(sin_cos_degrees(-degrees).cos, sin_cos_degrees(degrees).cos);
  }
  for (int i = 0; i <= 720; ++i) EXPECT_EQ(sin_cos_degrees(90 - i * 0.125).sin, sin_cos_degrees(i * 0.125).cos) << i;
}

// Frozen: a scene's bits depend on these. Each is within one unit of the last place of the true value.
TEST(Trig, BitsStayAsTheyAre) {
  struct Row {
    double degrees, sin, cos;
  };
  const Row rows[] = {
      {22.5, 0x1.87de2a6aea963p-2, 0x1.d906bcf328d46p-1},   {1, 0x1.1df0b2b89dd1ep-6, 0x1.ffec097f5af8ap-1},
      {17, 0x1.2b637cf83d5c8p-2, 0x1.e9a0c6e7bdb1fp-1},     {10, 0x1.63a1a7e0b7389p-3, 0x1.f838b8c811c17p-1},
      {359.5, -0x1.1df37c4954c21p-7, 0x1.fffb02599c9cdp-1}, {123.456, 0x1.ab2a9b25a9ab9p-1, -0x1.1a43870d371f9p-1},
  };
  for (const Row& row : rows) {
    EXPECT_EQ(sin_cos_degrees(row.degrees).sin, row.sin) << row.degrees;
    EXPECT_EQ(sin_cos_degrees(row.degrees).cos, row.cos) << row.degrees;
  }
}

}  // namespace
}  // namespace tumble::sim
