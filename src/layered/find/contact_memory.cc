#include "src/layered/find/contact_memory.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tumble::sim {
namespace {

std::pair<BodyIndex, BodyIndex> key_of(const ContactMemory& memory, std::size_t k) {
  const BodyIndex a = memory.a[k], b = memory.b[k];
  return a == kGround ? std::make_pair(b, kGround) : std::make_pair(std::min(a, b), std::max(a, b));
}

// A cursor over the contacts of a memory and their points.
struct Cursor {
  const ContactMemory& memory;
  std::size_t at = 0, point = 0;

  [[nodiscard]] bool done() const { return at == memory.size(); }
  void move_to(ContactMemory& to) {
    to.a.push_back(memory.a[at]);
    to.b.push_back(memory.b[at]);
    to.count.push_back(memory.count[at]);
    to.friction.push_back(memory.friction[at]);
    to.twist.push_back(memory.twist[at]);
    for (std::uint32_t k = 0; k < memory.count[at]; ++k, ++point) {
      to.feature.push_back(memory.feature[point]);
      to.impulse.push_back(memory.impulse[point]);
    }
    ++at;
  }
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

// Clears the columns and keeps their memory.
void empty(ContactMemory& memory) {
  memory.a.clear();
  memory.b.clear();
  memory.count.clear();
  memory.friction.clear();
  memory.twist.clear();
  memory.feature.clear();
  memory.impulse.clear();
}

}  // namespace

void remember_contacts(std::span<const Manifold> manifolds, std::span<const ManifoldPoint> points, Workers* workers,
                       ContactMemory& memory) {
  memory.count.resize(manifolds.size());
  for_ranges(workers, manifolds.size(), kManifoldsAPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) memory.count[k] = manifolds[k].count;
  });
  const std::size_t total = std::accumulate(memory.count.begin(), memory.count.end(), std::size_t{0});
  memory.a.resize(manifolds.size());
  memory.b.resize(manifolds.size());
  memory.friction.resize(manifolds.size());
  memory.twist.resize(manifolds.size());
  memory.feature.resize(total);
  memory.impulse.resize(total);
  for_ranges(workers, manifolds.size(), kManifoldsAPart, [&](std::size_t begin, std::size_t end) {
    std::size_t point = 0;
    for (std::size_t k = 0; k < begin; ++k) point += memory.count[k];
    for (std::size_t k = begin; k < end; ++k) {
      remember(manifolds[k], points, memory, k, point);
      point += memory.count[k];
    }
  });
}

void merge_contacts(ContactMemory& memory, const ContactMemory& added, ContactMemory& buffer) {
  ContactMemory& merged = buffer;
  empty(merged);
  Cursor old{memory}, fresh{added};
  while (!old.done() || !fresh.done()) {
    const bool take_old = fresh.done() || (!old.done() && key_of(memory, old.at) <= key_of(added, fresh.at));
    (take_old ? old : fresh).move_to(merged);
  }
  std::swap(memory, merged);
}

}  // namespace tumble::sim
