// Prints the symmetry errors of tilted grids: exactness_sweep thesis|layered N[,N…] SUBSTEPS[,SUBSTEPS…]. Exit status 1
// when one is not exactly zero or a cube has fallen through.
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
bool print_row(tumble::sim::Method method, std::uint32_t n, double dt, std::uint32_t substeps) {
  const tumble::test::SymmetryError error = tumble::test::tilted_grid_error(method, n, dt, substeps);
  std::printf("| %s | %u | 1/%.0f | %u | %g | %g | %.3f | %.2f |\n",
              method == tumble::sim::Method::kThesis ? "thesis" : "layered", n * n, 1 / dt, substeps, error.lateral,
              error.column_spread, error.lowest, error.seconds);
  std::fflush(stdout);
  return error.lateral == 0 && error.column_spread == 0 && error.lowest > 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string name = argc == 4 ? argv[1] : "";
  if (name != "thesis" && name != "layered") {
    std::fprintf(stderr, "usage: exactness_sweep thesis|layered N[,N...] SUBSTEPS[,SUBSTEPS...]\n");
    return 2;
  }
  const tumble::sim::Method method = name == "thesis" ? tumble::sim::Method::kThesis : tumble::sim::Method::kLayered;
  try {
    std::printf("| method | cubes | dt s | substeps | lateral m | column spread m | lowest centre m | CPU s |\n");
    std::printf("|---|---|---|---|---|---|---|---|\n");
    bool exact = true;
    for (const std::uint32_t n : numbers(argv[2])) {
      for (const double dt : {1.0 / 30, 1.0 / 300}) {
        for (const std::uint32_t substeps : numbers(argv[3])) exact = print_row(method, n, dt, substeps) && exact;
      }
    }
    return exact ? 0 : 1;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "exactness_sweep: %s\n", problem.what());
    return 4;
  }
}
