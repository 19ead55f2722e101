// A recovered log says what it is: whoever reads it later knows that its end, or steps within it, were lost.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "tests/support/sample_log.h"
#include "tumble/replay/comparison_scope.h"
#include "tumble/replay/continuation.h"
#include "tumble/replay/engine_log.h"

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

// Names by which a lost header's channels go stay in order, however many there are.
TEST(RecoveredLogs, TenThousandChannelsWithoutAHeaderKeepTheirOrder) {
  constexpr std::size_t kChannels = 10'002;
  EngineDef def = {{"engine of many channels", "1"}};
  for (std::size_t i = 0; i < kChannels; ++i) {
    std::string number = std::to_string(i);
    number.insert(0, 5 - number.size(), '0');
    def.declared.channels.push_back({"c" + number, {ChannelKind::kFloat64, ChannelScope::kWorld}});
  }
  const auto disk = std::make_shared<Disk>();
  sim::SceneDef start = small_scene();
  start.boxes.clear();
  const auto log = EngineLog::create(std::make_unique<MemorySink>(disk), def, start);
  ASSERT_TRUE(log.ok()) << log.error().message;
  for (const double value : {1.0, 2.0}) {
    for (const std::size_t i : {std::size_t{9998}, std::size_t{9999}, std::size_t{10'000}, kChannels - 1}) {
      ASSERT_TRUE((*log)->set_value(i, value + static_cast<double>(i)).ok());
    }
    ASSERT_TRUE((*log)->end_step(0.01).ok());
  }
  ASSERT_TRUE((*log)->finish().ok());
  const Result<LogReader> whole = open_memory(disk->bytes);
  ASSERT_TRUE(whole.ok()) << whole.error().message;
  const auto begin = disk->bytes.begin() + static_cast<std::ptrdiff_t>(whole->chunks().front().offset);
  const Result<RecoveredLog> recovered = recover_memory(Bytes(begin, disk->bytes.end()));
  ASSERT_TRUE(recovered.ok()) << recovered.error().message;
  EXPECT_TRUE(recovered->report.header_lost);
  Result<LogReader> saved = open_memory(recovered->bytes);
  ASSERT_TRUE(saved.ok()) << saved.error().message;
  const std::vector<Channel>& channels = saved->header().declared.channels;
  ASSERT_EQ(channels.size(), kChannels);
  EXPECT_EQ(channels[9999].name, "channel 09999");
  EXPECT_EQ(channels.back().name, "channel 10001");
  const Result<const StepRecord*> step = saved->read_step(2);
  ASSERT_TRUE(step.ok()) << step.error().message;
  EXPECT_EQ(std::get<double>((*step)->extras.values(10'000).value(0, ChannelKind::kFloat64)), 10'002.0);
}

}  // namespace
}  // namespace tumble::replay
