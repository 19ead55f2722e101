#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "src/process/child.h"
#include "tests/support/display.h"
#include "tests/support/program.h"
#include "tumble/render/png.h"
#include "tumble/replay/log_reader.h"

/// The window of `tumble live` on a display without a screen, and the logs that it leaves.
namespace tumble::test {

inline constexpr int kWidth = 480, kHeight = 360;
inline constexpr const char* kSize = "480x360";
inline constexpr double kDt = 1.0 / 64;

// A tower to throw at. The dt has few digits, so that a step of exactly that length was not measured by a clock.
inline constexpr const char* kScene = R"(
name = "played"
[world]
dt = 0.015625
[camera]
position = [6, -10, 4]
target = [0, 0, 1.5]
[[tower]]
count = 4
)";

// A window that is open; the display and the folder belong to the test.
class LiveWindow : public testing::Test {
 protected:
  void SetUp() override {
    if (::access((std::string(TUMBLE_PROGRAM) + "-live").c_str(), X_OK) != 0) {
      GTEST_SKIP() << "no window in this build (tools/setup.sh --only live)";
    }
    std::string why;
    display_ = Display::open(shop_.path("."), why);
    if (display_ == nullptr) GTEST_SKIP() << why;
    shop_.write("played.toml", kScene);
  }
  void TearDown() override {
    if (child_ != 0) {
      ::kill(child_, SIGKILL);
      process::wait_for(child_);
    }
  }

  void play(std::vector<std::string> more, const char* size = kSize) {
    process::Program program;
    program.words = {TUMBLE_PROGRAM, "live", "--size", size};
    program.words.insert(program.words.end(), more.begin(), more.end());
    program.folder = shop_.path(".");
    program.out = shop_.path("out");
    program.err = shop_.path("err");
    ASSERT_EQ(process::start(program, child_), 0);
    ASSERT_TRUE(display_->wait_for_window("tumble live")) << shop_.read("err");
    display_->move(360, 120);
    sleep_for(1);
  }
  process::ChildEnd wait() { return process::wait_for(std::exchange(child_, 0)); }
  void send(int signal) const { ::kill(child_, signal); }
  [[nodiscard]] Result<replay::LogReader> open(const std::string& name) const {
    return replay::LogReader::open(shop_.path(name));
  }
  void expect_replays(const std::string& name) const {
    const Outcome replayed = shop_.run({"replay", name});
    EXPECT_EQ(replayed.exit, 0) << replayed.out << replayed.err;
  }

  [[nodiscard]] render::Image image_of(const std::string& name) const {
    const Result<render::PngFile> file = render::read_png(shop_.path(name));
    EXPECT_TRUE(file.ok()) << name;
    return file.ok() ? file->image : render::Image::blank(kWidth, kHeight);
  }

  Workshop shop_;
  std::unique_ptr<Display> display_;
  pid_t child_ = 0;
};

inline std::vector<sim::TimedCommand> inputs_of(replay::LogReader& log) {
  std::vector<sim::TimedCommand> inputs;
  for (std::uint64_t k = log.first_state() + 1; k <= log.last_step(); ++k) {
    for (const sim::Command& input : (*log.read_hashes(k))->inputs) inputs.push_back({k, input});
  }
  return inputs;
}

inline double dt_of(replay::LogReader& log, std::uint64_t k) { return (*log.read_hashes(k))->dt; }

}  // namespace tumble::test
