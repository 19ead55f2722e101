// Ctrl-C in every kind of command: status 4 and a line, what was there stays, and nothing is left lying about.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "src/process/child.h"
#include "tests/support/display.h"
#include "tests/support/program.h"

namespace tumble::test {
namespace {

// A command that is running, until it is interrupted.
class Running {
 public:
  Running(const Workshop& shop, const std::vector<std::string>& words) : shop_(shop) {
    process::Program program;
    program.words = {TUMBLE_PROGRAM};
    program.words.insert(program.words.end(), words.begin(), words.end());
    program.folder = shop.path(".");
    program.out = shop.path("out");
    program.err = shop.path("err");
    if (std::filesystem::is_directory(shop.path("temporary"))) program.set["TMPDIR"] = shop.path("temporary");
    started_ = process::start(program, child_) == 0;
  }
  // Sends the signal once `begun` is true; gives up after a minute.
  Outcome interrupt(const std::function<bool()>& begun, int signal = SIGINT) {
    EXPECT_TRUE(started_);
    for (int k = 0; k < 6000 && !begun(); ++k) sleep_for(0.01);
    EXPECT_TRUE(begun());
    ::kill(child_, signal);
    return end();
  }
  Outcome end() { return {process::wait_for(child_).exit, shop_.read("out"), shop_.read("err")}; }

 private:
  const Workshop& shop_;
  pid_t child_ = 0;
  bool started_ = false;
};

// The part of an output that is being written.
std::function<bool()> has_part(const Workshop& shop) {
  return [&shop] { return !shop.names_with(".part-").empty(); };
}

void expect_interrupted(const Outcome& outcome, const std::string& command) {
  EXPECT_EQ(outcome.exit, 4) << outcome.err;
  EXPECT_TRUE(outcome.err.starts_with("tumble " + command + ": ")) << outcome.err;
  EXPECT_NE(outcome.err.find("interrupted"), std::string::npos) << outcome.err;
  EXPECT_TRUE(outcome.err.ends_with('\n'));
}

// What was there is there, and nothing beside it.
void expect_kept(const Workshop& shop, const std::string& name, const std::string& before) {
  EXPECT_EQ(shop.read(name), before);
  EXPECT_TRUE(shop.names_with(".part-").empty());
}

std::string table_of(std::size_t steps) {
  std::string text =
      "step,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z\n";
  for (std::size_t k = 0; k < steps; ++k) text += std::to_string(k) + ",1,0,0," + std::to_string(k) + ".5,1,0,0,0\n";
  return text;
}

TEST(Interrupt, ACommandThatOnlyReadsSaysSo) {
  const Workshop shop;
  ASSERT_EQ(shop.run_after("mkfifo table.csv; ", {"--version"}).exit, 0);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    Running import(shop, {"import", "table.csv", "-o", "new.tumble"});
    expect_interrupted(import.interrupt(
                           [&] {
                             sleep_for(0.5);
                             return true;
                           },
                           signal),
                       "import");
  }
  EXPECT_TRUE(shop.names_with("new.tumble").empty());
}

TEST(Interrupt, AnImportKeepsTheOldLog) {
  const Workshop shop;
  shop.write("small.csv", table_of(3));
  shop.write("large.csv", table_of(300'000));
  ASSERT_EQ(shop.run({"import", "small.csv", "-o", "log.tumble", "--header", "dt: 0.01"}).exit, 0);
  const std::string before = shop.read("log.tumble");
  Running import(shop, {"import", "large.csv", "-o", "log.tumble", "--header", "dt: 0.01"});
  expect_interrupted(import.interrupt(has_part(shop)), "import");
  expect_kept(shop, "log.tumble", before);
}

TEST(Interrupt, ARecoveryKeepsTheOldLogAndRemovesItsPart) {
  const Workshop shop;
  shop.record_small("old");
  const std::string before = shop.read("old.tumble");
  ASSERT_EQ(shop.run({"record", "brick_wall", "-o", "long.tumble", "--seconds", "60", "--quiet"}).exit, 0);
  Running recover(shop, {"recover", "long.tumble", "-o", "old.tumble"});
  expect_interrupted(recover.interrupt(has_part(shop)), "recover");
  expect_kept(shop, "old.tumble", before);
}

TEST(Interrupt, ASeriesKeepsTheOldTable) {
  const Workshop shop;
  shop.record_small("small");
  ASSERT_EQ(shop.run({"measure", "small.tumble", "--series", "s.csv"}).exit, 0);
  const std::string before = shop.read("s.csv");
  ASSERT_EQ(shop.run({"record", "brick_wall", "-o", "long.tumble", "--seconds", "60", "--quiet"}).exit, 0);
  Running measure(shop, {"measure", "long.tumble", "--series", "s.csv"});
  expect_interrupted(measure.interrupt(has_part(shop)), "measure");
  expect_kept(shop, "s.csv", before);
}

TEST(Interrupt, AMovieIsWholeOrNotThere) {
  const Workshop shop;
  shop.record_small("small");
  shop.write("old.mp4", "");
  const Outcome drawn = shop.run({"render", "small.tumble", "-o", "old.mp4", "--size", "64x48"});
  if (drawn.err.find("ffmpeg") != std::string::npos) GTEST_SKIP() << drawn.err;
  ASSERT_EQ(drawn.exit, 0) << drawn.err;
  const std::string before = shop.read("old.mp4");
  Running render(shop, {"render", "small.tumble", "-o", "old.mp4", "--size", "1280x720"});
  expect_interrupted(render.interrupt(has_part(shop)), "render");
  expect_kept(shop, "old.mp4", before);
}

TEST(Interrupt, NoTemporaryFolderStays) {
  const Workshop shop;
  shop.record_small("small");
  const std::filesystem::path place = shop.path("temporary");
  std::filesystem::create_directory(place);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    Running render(shop, {"render", "small.tumble", "-o", "new.mp4", "--size", "1280x720"});
    expect_interrupted(render.interrupt([&] { return !std::filesystem::is_empty(place); }, signal), "render");
    EXPECT_TRUE(std::filesystem::is_empty(place)) << *std::filesystem::directory_iterator(place);
  }
}

TEST(Interrupt, TheNextMovieRemovesTheFolderOfOneThatWasKilled) {
  const Workshop shop;
  shop.record_small("small");
  const std::filesystem::path place = shop.path("temporary");
  std::filesystem::create_directory(place);
  Running killed(shop, {"render", "small.tumble", "-o", "new.mp4", "--size", "1280x720"});
  static_cast<void>(killed.interrupt([&] { return !std::filesystem::is_empty(place); }, SIGKILL));
  EXPECT_FALSE(std::filesystem::is_empty(place));
  Running next(shop, {"render", "small.tumble", "-o", "new.mp4", "--size", "64x48"});
  EXPECT_EQ(next.end().exit, 0) << shop.read("err");
  EXPECT_TRUE(std::filesystem::is_empty(place)) << *std::filesystem::directory_iterator(place);
}

TEST(Interrupt, ALogThatIsBeingWrittenIsNotCalledTorn) {
  const Workshop shop;
  Running record(shop, {"record", "brick_wall", "-o", "log.tumble", "--seconds", "100000", "--quiet"});
  const auto has_chunk = [&] { return shop.read("log.tumble").size() > 200'000; };
  for (int k = 0; k < 6000 && !has_chunk(); ++k) sleep_for(0.01);
  const Outcome info = shop.run({"info", "log.tumble"});
  EXPECT_EQ(info.exit, 3);
  EXPECT_NE(info.err.find("is being written by process"), std::string::npos) << info.err;
  EXPECT_EQ((info.out + info.err).find("the rest was not written"), std::string::npos) << info.out << info.err;
  EXPECT_EQ(record.interrupt(has_chunk).exit, 4);
  EXPECT_EQ(shop.run({"info", "log.tumble"}).exit, 0);
}

TEST(Interrupt, AReaderThatLeavesIsNoFullDisk) {
  const Workshop shop;
  shop.write("suite.sh",
             std::string("'") + TUMBLE_PROGRAM + "' check tower 2> err | true; echo ${PIPESTATUS[0]} > status");
  ASSERT_EQ(shop.run_after("bash suite.sh; ", {"--version"}).exit, 0);
  EXPECT_EQ(shop.read("status"), "141\n");
  EXPECT_EQ(shop.read("err").find("full disk"), std::string::npos) << shop.read("err");
}

}  // namespace
}  // namespace tumble::test
