#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "replay/blame/blame.h"
#include "tests/support/log_memory.h"
#include "tests/support/sample_log.h"
#include "tests/support/sim_scenes.h"

/// Scenes and sentences for the tests of blame.
namespace tumble::replay {

/// A cube that floats at rest without gravity, and inputs.
inline sim::SceneDef floating(sim::Method method, std::vector<sim::TimedCommand> inputs, std::uint64_t steps) {
  sim::SceneDef scene = test::empty_space();
  scene.world.method = method;
  scene.boxes = {test::cube(1, {0, 0, 5})};
  scene.inputs = std::move(inputs);
  scene.steps = steps;
  return scene;
}

inline Blame blame_of(const sim::SceneDef& scene, const BlameQuestion& question) {
  Result<LogReader> log = open_memory(record_to_memory(scene));
  EXPECT_TRUE(log.ok());
  Result<Blame> found = blame(*log, question);
  EXPECT_TRUE(found.ok()) << found.error().message;
  return found.ok() ? *found : Blame{};
}

inline std::string story(const Blame& blame) {
  std::string text;
  for (const BlameAnswer& answer : blame.answers) text += answer.phase + ": " + answer.text + '\n';
  return text + blame.ends;
}

}  // namespace tumble::replay
