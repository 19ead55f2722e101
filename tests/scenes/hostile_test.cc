// Whatever bytes come in, a scene or an error goes out: no crash, no hang, no memory beyond bounds.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "src/base/rng.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::scenes {
namespace {

std::string repeated(const std::string& text, std::size_t count) {
  std::string out;
  out.reserve(text.size() * count);
  for (std::size_t i = 0; i < count; ++i) out += text;
  return out;
}

// Fails loudly on a scene; the message must be one that a terminal and a person can take.
void expect_error(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const Result<sim::SceneDef> scene = parse_scene(text, "bad.toml", overrides);
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().kind, ErrorKind::kBadInput);
  EXPECT_LT(scene.error().message.size(), 2000U);
  for (char c : scene.error().message) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20) << scene.error().message;
}

constexpr const char* kScene = R"(name = "x"
[world]
dt = 0.01
seconds = 1.0
[[box]]
id = 3
size = [1.0, 2.0, 1.0]
axis = [0, 0, 1]
degrees = 30.0
material = { friction = 0.5, texture = "brick" }
[[grid]]
rows = 2
cols = 2
jitter = { position = 0.1, seed = 1 }
[[input]]
time = 0.5
kind = "push"
id = 3
impulse = [1, 2, 3]
)";

TEST(HostileScenes, EveryCutOffTextGivesASceneOrAnError) {
  const std::string scene = kScene;
  for (std::size_t length = 0; length <= scene.size(); ++length) {
    const Result<sim::SceneDef> result = parse_scene(scene.substr(0, length), "cut.toml");
    EXPECT_TRUE(result.ok() || result.error().message.starts_with("cut.toml")) << length;
  }
}

TEST(HostileScenes, EveryChangedByteGivesASceneOrAnError) {
  const std::string scene = kScene;
  for (std::size_t place = 0; place < scene.size(); ++place) {
    for (int byte : {0x00, 0x0a, 0x22, 0x2e, 0x39, 0x5b, 0x5d, 0x7b, 0x7f, 0x80, 0xc3, 0xff}) {
      std::string changed = scene;
      changed[place] = static_cast<char>(byte);
      const Result<sim::SceneDef> result = parse_scene(changed, "changed.toml");
      EXPECT_TRUE(result.ok() || result.error().message.starts_with("changed.toml")) << place << " " << byte;
    }
  }
}

TEST(HostileScenes, RandomSplicesGiveASceneOrAnError) {
  const std::string scene = kScene;
  for (std::uint64_t trial = 0; trial < 3000; ++trial) {
    std::string text = scene;
    for (std::uint64_t edit = 0; edit < 1 + trial % 4; ++edit) {
      const std::size_t from = random_bits(trial, edit, 0) % scene.size();
      const std::size_t length = random_bits(trial, edit, 1) % 40;
      const std::size_t to = random_bits(trial, edit, 2) % text.size();
      text.replace(to, random_bits(trial, edit, 3) % 20, scene.substr(from, length));
    }
    const Result<sim::SceneDef> result = parse_scene(text, "spliced.toml");
    EXPECT_TRUE(result.ok() || result.error().message.starts_with("spliced.toml")) << text;
  }
}

// The parser's own assertions and "unreachable" places (src/scenes/toml.h).
TEST(HostileScenes, WhatTheParserThinksImpossibleIsAnError) {
  for (const char* text : {"[&", "[[=", "[[[1]]]", "[[&", "\u00fc = 1", "x = \u00fc", "x = 1\u00fc", "[[b\u00fcx]]"}) {
    expect_error(text);
  }
}

TEST(HostileScenes, DeepNestingIsAnError) {
  expect_error("x = " + repeated("[", 100000));
  expect_error("x = " + repeated("{a=", 100000));
  expect_error("x = " + repeated("[\n", 100000));
  expect_error("[" + repeated("a.", 100000) + "a]\n");
  expect_error(repeated("a.", 1000000) + "a = 1\n");
  expect_error("x = {" + repeated("a.", 100000) + "a = 1}\n");
  expect_error("x = " + repeated("[\n{" + repeated("a.", 200) + "a = ", 1000));
}

TEST(HostileScenes, CountsAreCheckedBeforeAnythingIsMade) {
  expect_error("[[grid]]\nrows = 4000000\ncols = 4000000\n");
  expect_error("[[grid]]\nrows = 9223372036854775807\ncols = 9223372036854775807\n");
  expect_error("[[pile]]\ncount = [4000000, 4000000, 4000000]\n");
  expect_error("[[pile]]\ncount = [2642246, 2642246, 2642246]\n");
  expect_error("[[pyramid]]\nbase = 4000000\n");
  expect_error("[[wall]]\ncourses = 4000000\nbricks = 2\n");
  expect_error(repeated("[[tower]]\ncount = 4000000\n", 1000));
}

TEST(HostileScenes, OverlongTextIsAnError) {
  expect_error(std::string((std::size_t{16} << 20) + 1, ' '));
  expect_error(repeated("#", 100) + "\n" + std::string(1 << 20, 'a'));
  expect_error("[[box]]\n" + std::string(1 << 20, 'a') + " = 1\n");
  expect_error("[[box]]\nsize = \"" + std::string(1 << 20, 'a') + "\"\n");
  expect_error("[[box]]\nsize = [" + repeated("1,", 100000) + "]\n");
}

TEST(HostileScenes, OverridesAreBoundedToo) {
  const std::string box = "[[box]]\n";
  expect_error(box, {""});
  expect_error(box, {"="});
  expect_error(box, {"=1"});
  expect_error(box, {"world.dt="});
  expect_error(box, {repeated("a.", 100000) + "a=1"});
  expect_error(box, {"x={" + repeated("a.", 100000) + "a=1}"});
  expect_error(box, {"x=" + repeated("[", 100000)});
  expect_error(box, {"world.dt=1\nbox=2"});
  expect_error(box, {"box.99999999999999999999.size=1"});
  expect_error(box, {std::string("world.dt=\0\x01\x1b", 12)});
}

}  // namespace
}  // namespace tumble::scenes
