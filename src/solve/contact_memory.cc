#include "src/solve/contact_memory.h"

#include <algorithm>

#include "src/collide/find_manifolds.h"
#include "src/collide/find_near_pairs.h"
#include "src/model/limits.h"

namespace tumble::sim {
namespace {

constexpr double kTouchGap = 1e-3;  // m; bodies of a resting start this close touch

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

void find_first_contact_memory(World& world) {
  const std::vector<std::uint8_t>& frozen = world.bodies().frozen;
  if (std::find(frozen.begin(), frozen.end(), 1) == frozen.end()) return;
  World awake = world;
  std::fill(awake.mutable_state().bodies.frozen.begin(), awake.mutable_state().bodies.frozen.end(), std::uint8_t{0});
  (void)find_near_pairs(awake, kDtMin);
  (void)find_manifolds(awake, kDtMin);
  Scratch& scratch = awake.mutable_scratch();
  const auto apart = [&](const Manifold& m) {
    const bool both_rest = frozen[m.b] != 0 && (m.a == kGround || !world.bodies().moves(m.a));
    const bool either_rests = both_rest || (m.a != kGround && frozen[m.a] != 0 && !world.bodies().moves(m.b));
    const auto points = points_of(scratch, m);
    const bool close = std::any_of(points.begin(), points.end(),
                                   [](const ManifoldPoint& point) { return point.separation < kTouchGap; });
    return !either_rests || !close;
  };
  std::erase_if(scratch.manifolds, apart);
  remember_contacts(scratch, world.mutable_state().contact_memory);
}

}  // namespace tumble::sim
