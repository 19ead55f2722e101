// Two recorders and one log: the second is told who writes it, and no byte of either is lost.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include "tests/outputs/small_table.h"
#include "tests/support/program.h"

namespace tumble::test {
namespace {

/// A recorder in real time that writes x.tumble, started by the shell before another command runs.
const char* const kRecorder =
    "\"$0\" record a.toml -o x.tumble --realtime --steps 3600 --quiet & echo $! >pid; "
    "while [ ! -s x.tumble ]; do sleep 0.02; done; ";

class LockedLog : public testing::Test {
 protected:
  void SetUp() override { shop_.write("a.toml", kSmallScene); }
  void TearDown() override { end(SIGKILL); }

  [[nodiscard]] Outcome beside(const std::vector<std::string>& words) {
    Outcome outcome = shop_.run_after(kRecorder, words);
    process_ = std::stoi(shop_.read("pid"));
    return outcome;
  }
  void end(int signal) {
    if (process_ <= 0) return;
    ::kill(process_, signal);
    for (int k = 0; k < 500 && ::kill(process_, 0) == 0; ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    process_ = 0;
  }

  Workshop shop_;
  pid_t process_ = 0;
};

TEST_F(LockedLog, TheSecondRecorderEndsAndNamesTheFirst) {
  const Outcome second = beside({"record", "a.toml", "-o", "./x.tumble"});
  EXPECT_EQ(second.exit, 2) << second.out << second.err;
  EXPECT_NE(second.err.find("process " + std::to_string(process_) + " ("), std::string::npos) << second.err;
  EXPECT_NE(second.err.find("record a.toml -o x.tumble --realtime"), std::string::npos) << second.err;
  end(SIGTERM);  // which completes the log
  const Outcome info = shop_.run({"info", "x.tumble"});
  EXPECT_EQ(info.exit, 0) << info.out << info.err;
  EXPECT_EQ(shop_.run({"record", "a.toml", "-o", "x.tumble", "--quiet"}).exit, 0) << "the lock ended with its holder";
}

TEST_F(LockedLog, ImportAndRecoverKeepOffToo) {
  shop_.write("t.csv", kSmallTable);
  const Outcome imported = beside({"import", "t.csv", "-o", "x.tumble"});
  EXPECT_EQ(imported.exit, 2) << imported.err;
  EXPECT_NE(imported.err.find("is being written by process"), std::string::npos) << imported.err;
  shop_.record_small("whole");
  const Outcome recovered = shop_.run({"recover", "whole.tumble", "-o", "x.tumble"});
  EXPECT_EQ(recovered.exit, 2) << recovered.err;
  EXPECT_NE(recovered.err.find("is being written by process"), std::string::npos) << recovered.err;
}

TEST(PipeForALog, IsRefusedAtOnceWhereNothingReadsIt) {
  const Workshop shop;
  shop.record_small("a");
  ASSERT_EQ(shop.run_after("mkfifo pipe; ", {"--version"}).exit, 0);
  const std::vector<std::vector<std::string>> commands = {{"record", "a.toml", "-o", "pipe"},
                                                          {"record", "--from", "a.tumble:3", "-o", "pipe"}};
  for (const std::vector<std::string>& words : commands) {
    const Outcome outcome = shop.run(words);
    EXPECT_EQ(outcome.exit, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("pipe that nothing reads"), std::string::npos) << outcome.err;
  }
}

TEST_F(LockedLog, ACrashReleasesTheLog) {
  EXPECT_EQ(beside({"record", "a.toml", "-o", "x.tumble"}).exit, 2);
  end(SIGKILL);
  EXPECT_EQ(shop_.run({"record", "a.toml", "-o", "x.tumble", "--quiet"}).exit, 0);
  EXPECT_EQ(shop_.run({"info", "x.tumble"}).exit, 0);
}

TEST_F(LockedLog, AReaderMayLookOn) {
  const Outcome info = beside({"info", "x.tumble"});
  EXPECT_EQ(info.exit, 3) << "a log without its end, as after a crash: " << info.err;
}

}  // namespace
}  // namespace tumble::test
