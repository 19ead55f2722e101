#include "src/layered/find/contact_memory.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tumble::sim {
namespace {

// A cursor over the contacts [at, end) of a memory and their points.
struct Cursor {
  Cursor(const ContactMemory& of, std::size_t begin, std::size_t end_of)
      : memory(of), at(begin), end(end_of), point(points_before(of, begin)) {}

  [[nodiscard]] bool done() const { return at == end; }
  // Copies the next contact to row `row` and its points to those from to_point on.
  void copy_to(ContactMemory& to, std::size_t row, std::size_t& to_point) {
    to.a[row] = memory.a[at];
    to.b[row] = memory.b[at];
    to.count[row] = memory.count[at];
    to.friction.set(row, memory.friction[at]);
    to.twist[row] = memory.twist[at];
    for (std::uint32_t k = 0; k < memory.count[at]; ++k, ++point, ++to_point) {
      to.feature[to_point] = memory.feature[point];
      to.impulse[to_point] = memory.impulse[point];
    }
    ++at;
  }

  const ContactMemory& memory;
  std::size_t at, end, point;
};

void remember(const Manifold& m, std::span<const ManifoldPoint> points, ContactMemory& memory, std::size_t at,
              std::size_t point) {
  memory.a[at] = m.a;
  memory.b[at] = m.b;
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
  memory.a.resize(contacts);
  memory.b.resize(contacts);
  memory.count.resize(contacts);
  memory.friction.resize(contacts);
  memory.twist.resize(contacts);
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

void remember_contacts(std::span<const Manifold> manifolds, std::span<const ManifoldPoint> points, Workers* workers,
                       ContactMemory& memory) {
  memory.count.resize(manifolds.size());
  for_ranges(workers, manifolds.size(), kManifoldsAPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) memory.count[k] = manifolds[k].count;
  });
  make_room(memory, manifolds.size(), points_before(memory, manifolds.size()));
  for_ranges(workers, manifolds.size(), kManifoldsAPart, [&](std::size_t begin, std::size_t end) {
    std::size_t point = points_before(memory, begin);
    for (std::size_t k = begin; k < end; ++k) {
      remember(manifolds[k], points, memory, k, point);
      point += memory.count[k];
    }
  });
}

void merge_contacts(ContactMemory& memory, const ContactMemory& added, Workers* workers, ContactMemory& buffer) {
  ContactMemory& merged = buffer;
  make_room(merged, memory.size() + added.size(), memory.feature.size() + added.feature.size());
  for_ranges(workers, memory.size(), kManifoldsAPart, [&](std::size_t begin, std::size_t end) {
    const auto place = [&](std::size_t k) {
      return k < memory.size() ? contacts_before(added, pair_of(memory, k)) : added.size();
    };
    Cursor old(memory, begin, end), fresh(added, begin == 0 ? 0 : place(begin), place(end));
    std::size_t point = old.point + fresh.point;
    for (std::size_t row = old.at + fresh.at; !old.done() || !fresh.done(); ++row) {
      const bool take_old = fresh.done() || (!old.done() && pair_of(memory, old.at) <= pair_of(added, fresh.at));
      (take_old ? old : fresh).copy_to(merged, row, point);
    }
  });
  std::swap(memory, merged);
}

}  // namespace tumble::sim
