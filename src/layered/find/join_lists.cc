#include "src/layered/find/join_lists.h"

#include <algorithm>

namespace tumble::sim {

void join_lists(std::span<ManifoldList> found, Workers* workers, LargeVector<Manifold>& manifolds,
                LargeVector<ManifoldPoint>& points) {
  if (found.empty()) return;
  std::size_t manifolds_before = manifolds.size(), points_before = points.size();
  for (ManifoldList& list : found) {
    list.manifolds_before = manifolds_before;
    list.points_before = points_before;
    manifolds_before += list.manifolds.size();
    points_before += list.points.size();
  }
  manifolds.resize(manifolds_before);
  points.resize(points_before);
  for_parts(workers, static_cast<unsigned>(found.size()), [&](unsigned part) {
    ManifoldList& list = found[part];
    for (Manifold& m : list.manifolds) m.first += static_cast<std::uint32_t>(list.points_before);
    std::ranges::copy(list.manifolds, manifolds.begin() + static_cast<std::ptrdiff_t>(list.manifolds_before));
    std::ranges::copy(list.points, points.begin() + static_cast<std::ptrdiff_t>(list.points_before));
  });
}

}  // namespace tumble::sim
