#include "src/layered/find/contact_memory.h"

#include <algorithm>
#include <numeric>

#include "src/base/check.h"

namespace tumble::sim {
namespace {

// Moves contact `from` of a memory to row `to` of a memory, which may be the same, from the last column on; its points
// lie before from_point, and go before to_point.
void move_contact(const ContactMemory& of, std::size_t from, std::size_t from_point, ContactMemory& memory,
                  std::size_t to, std::size_t to_point) {
  for (std::uint32_t k = 0; k < of.count[from]; ++k) {
    memory.feature[--to_point] = of.feature[--from_point];
    memory.impulse[to_point] = of.impulse[from_point];
  }
  memory.a[to] = of.a[from];
  memory.b[to] = of.b[from];
  memory.count[to] = of.count[from];
  memory.friction.set(to, of.friction[from]);
  memory.twist[to] = of.twist[from];
}

void remember(const Manifold& m, std::span<const ManifoldPoint> points, ContactMemory& memory, std::size_t at,
              std::size_t point) {
  memory.a[at] = m.a;
  memory.b[at] = m.b;
  memory.count[at] = m.count;
  memory.friction.set(at, plus_zero(m.asleep ? m.d : Vec3(m.t1 * m.force1 + m.t2 * m.force2)));
  memory.twist[at] = plus_zero(m.twist);
  for (const ManifoldPoint& p : points.subspan(m.first, m.count)) {
    memory.feature[point] = p.feature;
    memory.impulse[point] = plus_zero(p.impulse);
    ++point;
  }
}

// Room for so many contacts and points.
void make_room(ContactMemory& memory, std::size_t contacts, std::size_t points) {
  for (auto* column : {&memory.a, &memory.b, &memory.count}) column->resize(contacts);
  for (auto* column : {&memory.friction.x, &memory.friction.y, &memory.friction.z, &memory.twist}) {
    column->resize(contacts);
  }
  memory.feature.resize(points);
  memory.impulse.resize(points);
}

}  // namespace

std::size_t contacts_before(const ContactMemory& memory, const ContactPair& pair) {
  std::size_t low = 0, high = memory.size();
  while (low < high) {
    const std::size_t middle = std::midpoint(low, high);
    if (pair_of(memory, middle) < pair) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

std::size_t points_before(const ContactMemory& memory, std::size_t k) {
  return std::accumulate(memory.count.begin(), memory.count.begin() + static_cast<std::ptrdiff_t>(k), std::size_t{0});
}

void remember_contacts(std::span<const Manifold> manifolds, std::span<const ManifoldPoint> points,
                       const ContactMemory* added, const Homes& homes, Workers* workers, ContactMemory& memory) {
  SIM_CHECK((manifolds.empty() ? 0 : manifolds.back().first + manifolds.back().count) == points.size(), points.size());
  const ContactMemory none;
  const ContactMemory& more = added == nullptr ? none : *added;
  make_room(memory, manifolds.size() + more.size(), points.size() + more.feature.size());
  homes.for_all(workers, manifolds.size(), kManifoldsAPart, [&](std::size_t begin, std::size_t end) {
    if (begin == end) return;
    std::size_t next = contacts_before(more, pair_of(manifolds[begin].a, manifolds[begin].b));
    std::size_t point = points_before(more, next);
    for (std::size_t k = begin; k < end; ++k) {
      const Manifold& m = manifolds[k];
      SIM_DCHECK(k == 0 || m.first == manifolds[k - 1].first + manifolds[k - 1].count, k);
      for (; next < more.size() && pair_of(more, next) < pair_of(m.a, m.b); ++next) point += more.count[next];
      remember(m, points, memory, k + next, m.first + point);
    }
  });
  for_ranges(workers, more.size(), kManifoldsAPart, [&](std::size_t begin, std::size_t end) {
    std::size_t point = points_before(more, begin);
    for (std::size_t k = begin; k < end; ++k) {
      const auto after = std::ranges::upper_bound(manifolds, pair_of(more, k), {},
                                                  [](const Manifold& m) { return pair_of(m.a, m.b); });
      const std::size_t before = after == manifolds.end() ? points.size() : after->first;
      point += more.count[k];
      move_contact(more, k, point, memory, k + static_cast<std::size_t>(after - manifolds.begin()), before + point);
    }
  });
}

}  // namespace tumble::sim
