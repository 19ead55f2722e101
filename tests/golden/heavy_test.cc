// `check --heavy`: every session, gone on with from a snapshot of each of its steps.
#include <gtest/gtest.h>

#include <string>

#include "golden/run/go_on.h"
#include "golden/run/run_case.h"
#include "golden/suite/temporary_folder.h"
#include "golden/suite/text_files.h"
#include "tumble/scenes/scene_file.h"
#include "tumble/sim/hash.h"

namespace tumble::golden {
namespace {

// Two boxes that fall onto one another, one of them thrown in on the way.
sim::SceneDef scene_of(const std::string& method) {
  const Result<sim::SceneDef> scene = scenes::parse_scene("[world]\nmethod = \"" + method +
                                                              "\"\nsteps = 60\n[[box]]\nposition = [0, 0, 0.9]\n"
                                                              "[[input]]\nstep = 20\nkind = \"throw\"\nposition = "
                                                              "[0.2, 0, 2.4]\nvelocity = [0, 0.5, 0]\n",
                                                          "test.toml");
  EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().message);
  return *scene;
}

std::string first_fault(const sim::SceneDef& scene, const Reload& reload) {
  std::uint64_t steps = 0;
  Hash128 final_hash;
  const Result<std::string> fault = first_step_gone_on_otherwise(scene, reload, steps, final_hash);
  if (!fault.ok()) return "error: " + fault.error().message;
  if (fault->empty()) {
    EXPECT_EQ(steps, scene.steps);
  }
  return *fault;
}

TEST(Heavy, EachStepFromASnapshotIsThatOfTheSession) {
  for (const char* method : {"thesis", "layered"}) EXPECT_EQ(first_fault(scene_of(method), saved_and_loaded), "");
}

TEST(Heavy, NamesTheFirstStepWhoseSnapshotLostSomething) {
  const auto forgets = [](const sim::WorldState& state) -> Result<sim::WorldState> {
    sim::WorldState loaded = state;
    if (state.step >= 31) loaded.contact_memory = {};
    return loaded;
  };
  EXPECT_EQ(first_fault(scene_of("layered"), forgets),
            "step 32 from a snapshot: what is read back is another state than was written");
  const auto fails = [](const sim::WorldState& state) -> Result<sim::WorldState> {
    return state.step == 4 ? Result<sim::WorldState>(damaged("a column is short")) : Result<sim::WorldState>(state);
  };
  EXPECT_EQ(first_fault(scene_of("thesis"), fails),
            "step 5 from a snapshot: it cannot be read back: a column is short");
}

}  // namespace
}  // namespace tumble::golden
