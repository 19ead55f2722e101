#include "replay/session/frame_clock.h"

#include <gtest/gtest.h>

namespace tumble::replay {
namespace {

TEST(FrameClock, APunctualFrameStepsOnePeriod) {
  FrameClock clock(0.02, 0.08, 100);
  for (int k = 0; k < 5; ++k) {
    const double now = clock.due();
    EXPECT_NEAR(clock.begin(now), 0.02, 1e-12);
    clock.end(now + 0.005);
  }
  EXPECT_EQ(clock.frames().met, 5U);
  EXPECT_EQ(clock.frames().missed, 0U);
  EXPECT_EQ(clock.frames().bounded, 0U);
  EXPECT_NEAR(clock.frames().longest_s, 0.005, 1e-9);
}

TEST(FrameClock, ALateFrameIsMissedAndTheNextStepCatchesUp) {
  FrameClock clock(0.02, 0.08, 0);
  clock.begin(0);
  clock.end(0.05);
  EXPECT_EQ(clock.frames().missed, 1U);
  EXPECT_NEAR(clock.begin(0.05), 0.05, 1e-12);
  clock.end(0.06);
  EXPECT_EQ(clock.frames().met, 1U);
  EXPECT_NEAR(clock.due(), 0.07, 1e-12);
}

TEST(FrameClock, ASlowMachineCannotSpiral) {
  // Each frame takes twice as long as the step it makes: without a bound, steps would double for ever.
  FrameClock clock(0.02, 0.08, 0);
  double now = 0, step = 0;
  for (int k = 0; k < 20; ++k) {
    step = clock.begin(now);
    ASSERT_LE(step, 0.08);
    now += 2 * step;
    clock.end(now);
  }
  EXPECT_EQ(step, 0.08);
  EXPECT_EQ(clock.frames().missed, 20U);
  EXPECT_GE(clock.frames().bounded, 15U);
}

TEST(FrameClock, AStepIsNeverNothing) {
  FrameClock clock(0.02, 0.08, 0);
  clock.begin(0);
  EXPECT_EQ(clock.begin(0), 0.01) << "a clock that stands still";
  EXPECT_EQ(clock.begin(-1), 0.01) << "or goes back";
}

}  // namespace
}  // namespace tumble::replay
