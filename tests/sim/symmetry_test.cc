// The thesis's comparison scene: "Any horizontal displacement is a calculation error." Here there is none at all.
#include "tests/support/symmetry.h"

#include <gtest/gtest.h>

#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

// Larger grids and 40 and 200 substeps take longer than a test may; tools/scripts/checks/exactness.sh runs them.
class TiltedGrid : public testing::TestWithParam<std::uint32_t> {};

TEST_P(TiltedGrid, EndsWithoutLateralErrorAndColumnSpread) {
  for (const double dt : {1.0 / 30, 1.0 / 300}) {
    for (const std::uint32_t substeps : {1U, 4U, 10U}) {
      const SymmetryError error = tilted_grid_error(sim::Method::kThesis, GetParam(), dt, substeps);
      EXPECT_EQ(error.lateral, 0) << "dt " << dt << ", substeps " << substeps;
      EXPECT_EQ(error.column_spread, 0) << "dt " << dt << ", substeps " << substeps;
      EXPECT_GT(error.lowest, 0) << "a cube has fallen through the ground";
      EXPECT_GT(error.travelled, 0.5) << "nothing has happened";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, TiltedGrid, testing::Values(6, 10, 15, 20), testing::PrintToStringParamName());

// The measure sees a single cube that starts one grid step beside its column, or above its row.
TEST(TiltedGridCanary, OneGridStepIsSeen) {
  sim::SceneDef beside = tilted_grid(6), above = beside;
  beside.boxes[8].position.x() += 0x1p-36;
  above.boxes[8].position.z() += 0x1p-36;
  EXPECT_EQ(symmetry_error(tilted_grid(6), 6, 2).column_spread, 0);
  EXPECT_GT(symmetry_error(beside, 6, 2).lateral, 0);
  EXPECT_GT(symmetry_error(above, 6, 2).column_spread, 0);
}

}  // namespace
}  // namespace tumble::test
