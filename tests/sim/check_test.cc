// A failed check ends the process with status 4 and says where and what was found.
#include "src/base/check.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace tumble {
namespace {

constexpr int kExitStatus = 4;

TEST(CheckDeathTest, FailedOneEndsWithStatusFourAndNamesThePlace) {
  EXPECT_EXIT(SIM_CHECK(1 + 1 == 3), testing::ExitedWithCode(kExitStatus),
              "^tumble: tests/sim/check_test\\.cc:[0-9]+: internal check failed: 1 \\+ 1 == 3\n$");
}

TEST(CheckDeathTest, FailedOneShowsItsValues) {
  const std::uint64_t index = 7;
  const int least = -2;
  const double mass_kg = 0.1;
  const std::string_view name = "brick";
  EXPECT_EXIT(SIM_CHECK(index < 5, index, least, mass_kg, name), testing::ExitedWithCode(kExitStatus),
              "index < 5; found index, least, mass_kg, name = 7, -2, 0\\.1, \"brick\"\n$");
}

TEST(Check, ConditionThatHoldsDoesNothingAndIsEvaluatedOnce) {
  int evaluated = 0;
  SIM_CHECK(++evaluated == 1, evaluated);
  EXPECT_EQ(evaluated, 1);
}

// A check is one expression, so that it may stand where a statement without braces does.
TEST(Check, StandsAsOneStatement) {
  const bool ready = true;
  if (ready)
    SIM_CHECK(ready);
  else
    FAIL();
}

#if !defined(NDEBUG) || defined(TUMBLE_DCHECKS)
TEST(CheckDeathTest, CostlyOneIsOnInThisBuild) {
  EXPECT_EXIT(SIM_DCHECK(false, 3), testing::ExitedWithCode(kExitStatus), "internal check failed: false; found 3 = 3");
}
#else
TEST(Check, CostlyOneIsNotEvaluatedInThisBuild) {
  bool evaluated = false;
  SIM_DCHECK([&evaluated] { return evaluated = true; }());
  EXPECT_FALSE(evaluated);
}
#endif

}  // namespace
}  // namespace tumble
