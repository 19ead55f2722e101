#include "src/solve/contact_memory.h"

#include <algorithm>
#include <utility>

namespace tumble::sim {
namespace {

std::pair<BodyIndex, BodyIndex> key_of(const ContactMemory& memory, std::size_t k) {
  const BodyIndex a = memory.a[k], b = memory.b[k];
  return a == kGround ? std::make_pair(b, kGround) : std::make_pair(std::min(a, b), std::max(a, b));
}

// A reader that walks a memory contact by contact, with the points that belong to each.
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

}  // namespace
void remember_contacts(const Scratch& scratch, ContactMemory& memory) {
  memory.clear();
  for (const Manifold& m : scratch.manifolds) {
    memory.a.push_back(m.a);
    memory.b.push_back(m.b);
    memory.count.push_back(m.count);
    memory.friction.push_back(plus_zero(m.asleep ? m.d : Vec3(m.t1 * m.force1 + m.t2 * m.force2)));
    memory.twist.push_back(plus_zero(m.twist));
    for (const ManifoldPoint& point : points_of(scratch, m)) {
      memory.feature.push_back(point.feature);
      memory.impulse.push_back(plus_zero(point.impulse));
    }
  }
}

void merge_contacts(ContactMemory& memory, const ContactMemory& added) {
  ContactMemory merged;
  Cursor old{memory}, fresh{added};
  while (!old.done() || !fresh.done()) {
    const bool take_old = fresh.done() || (!old.done() && key_of(memory, old.at) <= key_of(added, fresh.at));
    (take_old ? old : fresh).move_to(merged);
  }
  memory = std::move(merged);
}

}  // namespace tumble::sim
