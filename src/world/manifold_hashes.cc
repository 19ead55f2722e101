#include "src/world/manifold_hashes.h"

#include <algorithm>

namespace tumble::sim {

// No padding, on any machine.
static_assert(sizeof(Manifold) == 22 * sizeof(double));
static_assert(sizeof(ManifoldPoint) == 6 * sizeof(double));

void add_fields(const Manifold& m, Hasher& hasher) {
  const auto add_numbers = [&](const std::uint32_t(&numbers)[2]) { hasher.add(std::span(numbers)); };
  add_numbers({m.a, m.b});
  for (const Vec3* v : {&m.n, &m.t1, &m.t2, &m.d}) hasher.add({v->x(), v->y(), v->z()});
  hasher.add(m.offset);
  add_numbers({m.first, m.count});
  add_numbers({m.layer, m.asleep ? 1U : 0U});
  hasher.add({m.friction, m.friction_dynamic, m.restitution, m.force1, m.force2, m.twist});
}

void add_fields(const ManifoldPoint& point, Hasher& hasher) {
  hasher.add({point.p, point.q, point.separation, point.impulse, point.load});
  hasher.add(std::uint64_t{point.feature});
}

void add_manifolds(std::span<const Manifold> manifolds, std::span<const ManifoldPoint> points, std::size_t begin,
                   std::size_t end, Hasher& hasher) {
  for (; begin < end; begin += kManifoldsABlock) {
    const std::span<const Manifold> block = manifolds.subspan(begin, std::min(kManifoldsABlock, end - begin));
    hasher.add_rows(block, [](const Manifold& m, Hasher& to) { add_fields(m, to); });
    const Manifold &first = block.front(), &last = block.back();
    hasher.add_rows(points.subspan(first.first, last.first + last.count - first.first),
                    [](const ManifoldPoint& point, Hasher& to) { add_fields(point, to); });
  }
}

void hash_manifolds(const Scratch& scratch, Hasher& hasher) {
  add_manifolds(scratch.manifolds, scratch.manifold_points, 0, scratch.manifolds.size(), hasher);
}

}  // namespace tumble::sim
