#include "src/layered/islands/island_scale.h"

#include <cmath>

namespace tumble::sim {

void measure_islands(const Bodies& bodies, Scratch& scratch) {
  IslandScratch& islands = scratch.islands;
  islands.bodies.assign(bodies.size(), 0);
  islands.heaviest.assign(bodies.size(), 0);
  islands.reach2.assign(bodies.size(), 1);
  const unsigned parts = part_count(scratch.workers, bodies.size(), kBodiesAPart);
  work_together(scratch.workers, parts, [&](const Worker& worker) {
    const Worker::Share share = worker.share(bodies.size());
    for (std::size_t i = share.begin; i < share.end; ++i) {
      if (scratch.graph.start[i] == scratch.graph.start[i + 1]) continue;
      const BodyIndex island = islands.of[i];
      worker.add(islands.bodies[island], 1U);
      worker.raise(islands.heaviest[island], bodies.mass[i]);
      worker.raise(islands.reach2[island], dot(bodies.half_extent[i], bodies.half_extent[i]));
    }
  });
}

IslandScale scale_of(const IslandScratch& islands, BodyIndex i) {
  const BodyIndex island = islands.of[i];
  const double reach = std::sqrt(islands.reach2[island]);
  const double most = static_cast<double>(islands.bodies[island]) * islands.heaviest[island] * reach;  // kg·m
  return {reach, VelocityGrid::kMagic * (power_of_two(most) / 2048)};
}

}  // namespace tumble::sim
