#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "tests/support/log_memory.h"
#include "tumble/replay/log_writer.h"
#include "tumble/replay/session.h"

namespace tumble::replay {

using Words = std::vector<std::uint64_t>;

/// Records a session whose log lies in step `lie`: change(state, words, counters) alters what is written, not the
/// session.
template <class Change>
Bytes record_with_lie(const sim::SceneDef& scene, std::uint64_t lie, Change change) {
  const auto disk = std::make_shared<Disk>();
  Result<Session> session = Session::start(scene);
  auto writer = LogWriter::create(std::make_unique<MemorySink>(disk), header_for(scene), session->world().state());
  sim::PhaseHashes hashes;
  for (std::uint64_t k = 1; k <= scene.steps; ++k) {
    hashes.clear();
    Result<TakenStep> taken = session->step({}, &hashes);
    EXPECT_TRUE(taken.ok());
    Words words = hashes.words();
    sim::WorldState state = session->world().state();
    if (k == lie) change(state, words, taken->counters);
    EXPECT_TRUE((*writer)->append({state.def.dt, taken->inputs, words, taken->counters}, state).ok());
  }
  EXPECT_TRUE((*writer)->finish().ok());
  return disk->bytes;
}

}  // namespace tumble::replay
