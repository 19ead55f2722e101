#include "tests/support/display.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <thread>
#include <utility>

#include "src/process/child.h"
#include "src/process/run_child.h"

namespace tumble::test {
namespace {

constexpr int kWidth = 800, kHeight = 600;
constexpr double kPatience = 60;  // s

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

bool is_there(const std::string& program) {
  process::Program check;
  check.words = {program, program == "Xvfb" ? "-help" : "version"};
  check.out = check.err = "/dev/null";
  pid_t child = 0;
  if (process::start(check, child) != 0) return false;
  process::wait_for(child);
  return true;
}

// The header of Xvfb's file: XWD, big-endian numbers of four bytes.
std::uint32_t number(const std::string& bytes, std::size_t index) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k) value = value << 8U | static_cast<unsigned char>(bytes[index * 4 + k]);
  return value;
}

}  // namespace

void sleep_for(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

std::unique_ptr<Display> Display::open(const std::string& folder, std::string& why) {
  for (const char* program : {"Xvfb", "xdotool"}) {
    if (is_there(program)) continue;
    why = std::string(program) + " is not installed (tools/setup.sh --only live)";
    return nullptr;
  }
  std::unique_ptr<Display> display(new Display);
  display->folder_ = folder;
  process::Program server;
  const std::string screen = std::to_string(kWidth) + "x" + std::to_string(kHeight) + "x24";
  // Without -noreset the server starts again when its last client leaves: xdotool, while the window connects.
  server.words = {"Xvfb",   "-displayfd", "1",         "-screen",   "0",   screen,
                  "-fbdir", folder,       "-nocursor", "-nolisten", "tcp", "-noreset"};
  server.out = folder + "/display";
  server.err = folder + "/display.err";
  if (process::start(server, display->server_) != 0) {
    why = "Xvfb does not start";
    return nullptr;
  }
  for (double waited = 0; waited < kPatience; waited += 0.05) {
    const std::string number = text_of(server.out);
    if (number.ends_with('\n')) {
      display->name_ = ":" + number.substr(0, number.size() - 1);
      ::setenv("DISPLAY", display->name_.c_str(), 1);
      return display;
    }
    sleep_for(0.05);
  }
  why = "Xvfb gives no display: " + text_of(server.err);
  return nullptr;
}

Display::~Display() { close(); }

void Display::close() {
  if (server_ == 0) return;
  ::kill(server_, SIGTERM);  // so that it removes its lock and its socket
  process::wait_for(std::exchange(server_, 0));
}

bool Display::tool(const std::vector<std::string>& words) const {
  process::Program program;
  program.words = {"xdotool"};
  program.words.insert(program.words.end(), words.begin(), words.end());
  program.out = folder_ + "/xdotool.out";
  program.err = folder_ + "/xdotool.err";
  const Result<process::ChildEnd> end = process::run_child(program, kPatience);
  return end.ok() && end->well();
}

bool Display::wait_for_window(const std::string& title) const {
  for (double waited = 0; waited < kPatience; waited += 0.2) {
    if (tool({"search", "--onlyvisible", "--name", title, "windowfocus"})) return true;
    sleep_for(0.2);
  }
  return false;
}

void Display::move(int x, int y) const { EXPECT_TRUE(tool({"mousemove", std::to_string(x), std::to_string(y)})); }

void Display::hold(int button, double seconds) const {
  EXPECT_TRUE(tool({"mousedown", std::to_string(button)}));
  sleep_for(seconds);
  EXPECT_TRUE(tool({"mouseup", std::to_string(button)}));
}

void Display::drag(int button, int x, int y) const {
  EXPECT_TRUE(tool({"mousedown", std::to_string(button)}));
  EXPECT_TRUE(tool({"mousemove_relative", "--", std::to_string(x), std::to_string(y)}));
  sleep_for(0.3);
  EXPECT_TRUE(tool({"mouseup", std::to_string(button)}));
}

void Display::key(const std::string& key) const { EXPECT_TRUE(tool({"key", key})); }

render::Image Display::picture(int width, int height) const {
  const std::string bytes = text_of(folder_ + "/Xvfb_screen0");
  EXPECT_GT(bytes.size(), 100U);
  const std::size_t line = number(bytes, 12), begin = number(bytes, 0) + std::size_t{12} * number(bytes, 19);
  EXPECT_EQ(number(bytes, 11), 32U) << "bits of a pixel";
  render::Image image = render::Image::blank(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t from = begin + static_cast<std::size_t>(y) * line + static_cast<std::size_t>(x) * 4;
      for (std::size_t k = 0; k < 3; ++k) {
        image.rgb[image.at(x, y) + k] = static_cast<std::uint8_t>(bytes.at(from + 2 - k));  // blue, green, red
      }
    }
  }
  return image;
}

}  // namespace tumble::test
