#include "src/layered/islands/island_scale.h"

#include <algorithm>
#include <cmath>

#include "src/world/for_bodies.h"

namespace tumble::sim {

namespace {

// By the body that stands for an island: how many there are, in the place of the layers that assign_levels counts.
std::vector<std::uint32_t>& bodies_of(IslandScratch& islands) { return islands.layers; }
const std::vector<std::uint32_t>& bodies_of(const IslandScratch& islands) { return islands.layers; }

// Bodies of one island that follow one another.
struct Run {
  BodyIndex island = 0;
  std::uint32_t bodies = 0;
  double heaviest = 0, reach2 = 1;

  void add_to(IslandScratch& islands, const Worker& worker) const {
    if (bodies == 0) return;
    worker.add(bodies_of(islands)[island], bodies);
    worker.raise(islands.heaviest[island], heaviest);
    worker.raise(islands.reach2[island], reach2);
  }
};

}  // namespace

void measure_islands(const Bodies& bodies, Scratch& scratch) {
  IslandScratch& islands = scratch.islands;
  const std::size_t n = bodies.size();
  fill_bodies(scratch, n, bodies_of(islands), 0U);
  fill_bodies(scratch, n, islands.heaviest, 0.0);
  fill_bodies(scratch, n, islands.reach2, 1.0);
  const unsigned parts = scratch.homes.parts_for(scratch.workers, n, kBodiesAPart);
  work_together(scratch.workers, parts, [&](const Worker& worker) {
    Run run;
    scratch.homes.for_own(worker, n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        if (scratch.graph.start[i] == scratch.graph.start[i + 1]) continue;
        if (islands.of[i] != run.island) {
          run.add_to(islands, worker);
          run = {islands.of[i]};
        }
        ++run.bodies;
        run.heaviest = std::max(run.heaviest, bodies.mass[i]);
        run.reach2 = std::max(run.reach2, dot(bodies.half_extent[i], bodies.half_extent[i]));
      }
    });
    run.add_to(islands, worker);
  });
}

IslandScale scale_of(const IslandScratch& islands, BodyIndex i) {
  const BodyIndex island = islands.of[i];
  const double reach = std::sqrt(islands.reach2[island]);
  const double most = static_cast<double>(bodies_of(islands)[island]) * islands.heaviest[island] * reach;  // kg·m
  return {reach, VelocityGrid::kMagic * (power_of_two(most) / 2048)};
}

}  // namespace tumble::sim
