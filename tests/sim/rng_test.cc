#include "src/base/rng.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace tumble {
namespace {

// Computed from the definition by another program, in whole numbers.
TEST(Rng, BitsStayAsTheyAre) {
  EXPECT_EQ(random_bits(0, 0, 0), 0x238275bc38fcbe91U);
  EXPECT_EQ(random_bits(7, 3, 0), 0xd0ac2efad2a1e5d0U);
  EXPECT_EQ(random_bits(7, 3, 1), 0xef088a19cf56d067U);
  EXPECT_EQ(random_bits(7, 3, 2), 0x8490c52f93c7df65U);
  EXPECT_EQ(random_symmetric(7, 3, 0), 0x1.42b0bbeb4a878p-1);
}

TEST(Rng, EverySeedCounterAndDrawGivesItsOwnNumber) {
  std::set<std::uint64_t> seen;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (std::uint64_t counter = 0; counter < 20; ++counter) {
      for (std::uint64_t draw = 0; draw < 20; ++draw) seen.insert(random_bits(seed, counter, draw));
    }
  }
  EXPECT_EQ(seen.size(), 8000U);
}

TEST(Rng, SymmetricNumbersFillTheIntervalEvenly) {
  constexpr int kCount = 100000;
  double low = 1, high = -1, sum = 0, squares = 0;
  for (std::uint64_t i = 0; i < kCount; ++i) {
    const double u = random_symmetric(42, i, 0);
    ASSERT_GE(u, -1.0);
    ASSERT_LT(u, 1.0);
    low = std::min(low, u);
    high = std::max(high, u);
    sum += u;
    squares += u * u;
  }
  EXPECT_LT(low, -0.999);
  EXPECT_GT(high, 0.999);
  // Five standard deviations of the mean (1/√(3 n)) and of the mean square about 1/3 (√(4/45/n)).
  EXPECT_LT(std::fabs(sum / kCount), 0.0092);
  EXPECT_LT(std::fabs(squares / kCount - 1.0 / 3), 0.0048);
}

}  // namespace
}  // namespace tumble
