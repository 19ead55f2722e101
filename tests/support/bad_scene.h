#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tumble/scenes/scene_file.h"

namespace tumble::test {

/// A scene with one thing wrong, and the whole message that must come of it. Its file is called bad.toml.
struct BadScene {
  const char* name;
  const char* text;
  const char* message;
  std::vector<std::string> overrides = {};
};

inline void PrintTo(const BadScene& bad, std::ostream* out) { *out << bad.name; }

inline std::string name_of(const testing::TestParamInfo<BadScene>& info) { return info.param.name; }

inline void expect_its_message(const BadScene& bad) {
  const Result<sim::SceneDef> scene = scenes::parse_scene(bad.text, "bad.toml", bad.overrides);
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(scene.error().message, bad.message);
}

}  // namespace tumble::test
