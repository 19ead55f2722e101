#pragma once

#include <cstdint>

#include "tumble/sim/scene.h"

namespace tumble::test {

/// How far a tilted grid of n × n cubes has left its symmetry after a run (the thesis's accuracy test).
struct SymmetryError {
  double lateral = 0;        ///< largest |x(end) − x(0)|, m
  double column_spread = 0;  ///< largest difference in y or z between the cubes of a row, m
  double lowest = 0;         ///< lowest centre, m: nothing falls through
  double travelled = 0;      ///< largest |y(end) − y(0)|, m: something happened
  double seconds = 0;        ///< CPU time of the steps
};
/// Runs a scene of tilted_grid(n), as it is or disturbed, for so many seconds.
SymmetryError symmetry_error(const sim::SceneDef& scene, std::uint32_t n, double seconds);
/// The thesis's 5 s of it.
SymmetryError tilted_grid_error(sim::Method method, std::uint32_t n, double dt, std::uint32_t substeps);

}  // namespace tumble::test
