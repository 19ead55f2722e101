#include "tests/support/symmetry.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "tests/support/sim_scenes.h"

namespace tumble::test {

SymmetryError symmetry_error(const sim::SceneDef& scene, std::uint32_t n, double seconds) {
  sim::World world = made(scene);
  const sim::Bodies start = world.bodies();
  const std::clock_t begun = std::clock();
  const auto steps = static_cast<std::uint64_t>(std::lround(seconds / scene.world.dt));
  for (std::uint64_t k = 0; k < steps; ++k) advance(world);

  SymmetryError error;
  error.seconds = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
  const sim::Bodies& end = world.bodies();
  error.lowest = end.position.z[0];
  for (std::size_t i = 0; i < end.size(); ++i) {
    const std::size_t first = i - i % n;  // of its row
    error.lateral = std::max(error.lateral, std::fabs(end.position.x[i] - start.position.x[i]));
    error.travelled = std::max(error.travelled, std::fabs(end.position.y[i] - start.position.y[i]));
    error.lowest = std::min(error.lowest, end.position.z[i]);
    for (const auto* column : {&end.position.y, &end.position.z}) {
      error.column_spread = std::max(error.column_spread, std::fabs((*column)[i] - (*column)[first]));
    }
  }
  return error;
}

SymmetryError tilted_grid_error(sim::Method method, std::uint32_t n, double dt, std::uint32_t substeps) {
  sim::SceneDef scene = tilted_grid(n);
  scene.world.method = method;
  scene.world.dt = dt;
  scene.world.substeps = substeps;
  return symmetry_error(scene, n, 5);
}

}  // namespace tumble::test
