// A played session is ended once, whoever asks for it and however many do.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <thread>
#include <vector>

#include "replay/live/live_session.h"
#include "replay/log/byte_memory.h"
#include "tests/support/sim_scenes.h"

namespace tumble::replay {
namespace {

TEST(LiveFinish, ByThreeThreadsAtOnce) {
  for (int round = 0; round < 20; ++round) {
    LiveOptions options;
    options.log = "memory.tumble";
    options.begin = [](const std::string&) {
      auto sink = std::make_unique<MemoryByteSink>(std::make_shared<std::vector<std::byte>>(), "memory.tumble");
      return Recorder::start(std::move(sink), test::tower(2), {});
    };
    const auto session = LiveSession::start(std::move(options));
    ASSERT_TRUE(session.ok()) << session.error().message;
    std::array<std::size_t, 3> logs = {};
    {
      std::vector<std::jthread> threads;
      threads.reserve(logs.size());
      for (std::size_t& count : logs) {
        threads.emplace_back([&session, &count] {
          const Result<std::vector<SavedLog>> saved = (*session)->finish();
          count = saved.ok() ? saved->size() : 0;
        });
      }
    }
    EXPECT_EQ(logs, (std::array<std::size_t, 3>{1, 1, 1}));
  }
}

}  // namespace
}  // namespace tumble::replay
