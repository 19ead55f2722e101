// A recovered log says what it is: whoever reads it later knows that its end, or steps within it, were lost.
#include <gtest/gtest.h>

#include "tests/support/sample_log.h"
#include "tumble/replay/comparison_scope.h"
#include "tumble/replay/continuation.h"

namespace tumble::replay {
namespace {

TEST(RecoveredLogs, OneWhoseEndWasLostIsNotCalledWhole) {
  const SampleLog& s = sample_log();
  const Result<RecoveredLog> recovered = recover_memory(s.joined({0, 1, 2, 3}));
  ASSERT_TRUE(recovered.ok()) << recovered.error().message;
  const Result<LogReader> log = open_memory(recovered->bytes);
  ASSERT_TRUE(log.ok()) << log.error().message;
  EXPECT_EQ(log->header().declared.cut_short, "recovered up to step 18, and its end was lost");
  EXPECT_NE(not_whole(*log).find("its session may have gone on: recovered up to step 18"), std::string::npos)
      << not_whole(*log);
  const Result<RecoveredLog> of_its_end = recover_memory(s.joined({0, 1, 2, 3, 5, 6}));
  ASSERT_TRUE(of_its_end.ok()) << of_its_end.error().message;
  EXPECT_EQ(open_memory(of_its_end->bytes)->header().declared.cut_short, "recovered up to step 18 of 24");
  const Result<RecoveredLog> whole = recover_memory(s.bytes);
  EXPECT_EQ(not_whole(*open_memory(whole->bytes)), "");
}

TEST(RecoveredLogs, ASessionGoesOnFromAStateBehindAGap) {
  const SampleLog& s = sample_log();
  const Result<RecoveredLog> recovered = recover_memory(s.joined({0, 1, 3, 4, 5, 6}));
  ASSERT_TRUE(recovered.ok()) << recovered.error().message;
  Result<LogReader> log = open_memory(recovered->bytes);  // without steps 7 to 12
  ASSERT_TRUE(log.ok()) << log.error().message;
  GoOnOptions options;
  options.steps = 4;
  const Result<Continuation> behind = continuation_of(*log, 15, options);
  ASSERT_TRUE(behind.ok()) << behind.error().message;
  EXPECT_EQ(behind->state.step, 15U);
  const Result<Continuation> before = continuation_of(*log, 4, options);
  ASSERT_FALSE(before.ok()) << "inputs of the lost steps are not known";
  EXPECT_NE(before.error().message.find("step 7 is lost"), std::string::npos) << before.error().message;
  options.keep_inputs = false;
  EXPECT_TRUE(continuation_of(*log, 4, options).ok());
}

}  // namespace
}  // namespace tumble::replay
