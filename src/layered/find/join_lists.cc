#include "src/layered/find/join_lists.h"

#include <algorithm>

namespace tumble::sim {
namespace {

// Calls copy(list, begin, end) for a worker's share of the items of all lists. before: of a list, the items before it.
template <class Size, class Before, class Copy>
void for_share(std::span<const ManifoldList> lists, const Worker::Share& share, Size size, Before before, Copy copy) {
  for (const ManifoldList& list : lists) {
    const std::size_t first = before(list), end = first + size(list);
    if (share.begin >= end || share.end <= first) continue;
    copy(list, std::max(share.begin, first) - first, std::min(share.end, end) - first);
  }
}

}  // namespace

void join_lists(std::span<ManifoldList> found, Workers* workers, LargeVector<Manifold>& manifolds,
                LargeVector<ManifoldPoint>& points) {
  if (found.empty()) return;
  const std::size_t first_manifold = manifolds.size(), first_point = points.size();
  std::size_t manifolds_before = first_manifold, points_before = first_point;
  for (ManifoldList& list : found) {
    list.manifolds_before = manifolds_before;
    list.points_before = points_before;
    manifolds_before += list.manifolds.size();
    points_before += list.points.size();
  }
  manifolds.resize(manifolds_before);
  points.resize(points_before);
  // The first worker has found no list of these, so the ranges are cut anew for all.
  work_together(workers, static_cast<unsigned>(found.size()) + 1, [&](const Worker& worker) {
    const auto share = [&](std::size_t from, std::size_t to) {
      const Worker::Share own = worker.share(to - from);
      return Worker::Share{from + own.begin, from + own.end};
    };
    for_share(
        found, share(first_manifold, manifolds.size()), [](const ManifoldList& list) { return list.manifolds.size(); },
        [](const ManifoldList& list) { return list.manifolds_before; },
        [&](const ManifoldList& list, std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k) {
            Manifold& m = manifolds[list.manifolds_before + k] = list.manifolds[k];
            m.first += static_cast<std::uint32_t>(list.points_before);
          }
        });
    for_share(
        found, share(first_point, points.size()), [](const ManifoldList& list) { return list.points.size(); },
        [](const ManifoldList& list) { return list.points_before; },
        [&](const ManifoldList& list, std::size_t begin, std::size_t end) {
          std::copy(list.points.begin() + static_cast<std::ptrdiff_t>(begin),
                    list.points.begin() + static_cast<std::ptrdiff_t>(end),
                    points.begin() + static_cast<std::ptrdiff_t>(list.points_before + begin));
        });
  });
}

}  // namespace tumble::sim
