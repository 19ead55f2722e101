// Prints the symmetry errors of tilted grids: exactness_sweep N[,N…] SUBSTEPS[,SUBSTEPS…]. Exit status 1 when one is
// not exactly zero or a cube has fallen through.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/symmetry.h"

namespace {

std::vector<std::uint32_t> numbers(const std::string& list) {
  std::vector<std::uint32_t> found;
  std::istringstream in(list);
  for (std::string item; std::getline(in, item, ',');) {
    found.push_back(static_cast<std::uint32_t>(std::strtoul(item.c_str(), nullptr, 10)));
  }
  return found;
}

// True when the run kept its symmetry.
bool print_row(std::uint32_t n, double dt, std::uint32_t substeps) {
  const tumble::test::SymmetryError error = tumble::test::tilted_grid_error(n, dt, substeps);
  std::printf("| %u | 1/%.0f | %u | %g | %g | %.3f | %.2f |\n", n * n, 1 / dt, substeps, error.lateral,
              error.column_spread, error.lowest, error.seconds);
  std::fflush(stdout);
  return error.lateral == 0 && error.column_spread == 0 && error.lowest > 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: exactness_sweep N[,N...] SUBSTEPS[,SUBSTEPS...]\n");
    return 2;
  }
  try {
    std::printf("| cubes | dt s | sub-steps | lateral m | column spread m | lowest centre m | CPU s |\n");
    std::printf("|---|---|---|---|---|---|---|\n");
    bool exact = true;
    for (const std::uint32_t n : numbers(argv[1])) {
      for (const double dt : {1.0 / 30, 1.0 / 300}) {
        for (const std::uint32_t substeps : numbers(argv[2])) exact = print_row(n, dt, substeps) && exact;
      }
    }
    return exact ? 0 : 1;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "exactness_sweep: %s\n", problem.what());
    return 4;
  }
}
