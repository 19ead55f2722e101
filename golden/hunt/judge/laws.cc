#include "golden/hunt/judge/laws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "golden/hunt/judge/bounds.h"
#include "golden/hunt/judge/mechanics.h"
#include "src/math/grid.h"

namespace tumble::hunt {
namespace {

using sim::Bodies;
using sim::BodyIndex;
using sim::cross;
using sim::dot;
using sim::length;
using sim::Vec3;

bool finite(const Vec3& v) { return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z()); }
bool on_grid(const Vec3& v, double step) {
  return std::ranges::all_of(std::array{v.x(), v.y(), v.z()}, [step](double x) {
    return x / step == std::floor(x / step) && !(x == 0 && std::signbit(x));
  });
}

}  // namespace

void Worst::add(std::uint64_t step, sim::BodyId body, double value, double bound, const char* what) {
  if (is_broken()) return;
  if (!std::isfinite(bound)) {
    worst_ = broken(step, body, std::string("values are too large, or none, to be judged: ") + what);
    return;
  }
  const bool breaks = !(value <= bound);
  const bool nearer = worst_.bound <= 0 || value * worst_.bound > worst_.value * bound;
  if (!breaks && !nearer) return;
  worst_ = broken(step, body, what, value, bound, unit_);
  if (!breaks) worst_.outcome = Outcome::kHeld;
}

Judgement judge_finishes(const Trace& trace) {
  if (trace.failure.empty()) return held();
  if (trace.other_bodies) return broken(*trace.other_bodies, 0, trace.failure);
  return broken(trace.states.size(), 0, "the session ends early: " + trace.failure);
}

Judgement judge_numbers(const Trace& trace) {
  for (std::size_t k = 0; k < trace.states.size(); ++k) {
    const Bodies& bodies = trace.states[k].bodies;
    for (BodyIndex i = 0; i < bodies.size(); ++i) {
      const Vec3 x = bodies.position[i], v = bodies.velocity[i], w = bodies.spin[i];
      const double off = std::fabs(squared_length(bodies.orientation[i]) - 1);
      const double unit = trace.external ? kUnitOfFloats : 1e-12;
      if (!finite(x) || !finite(v) || !finite(w) || !(off <= unit))
        return broken(k, bodies.id[i], "a value is no number, or an orientation has not unit length", off, unit);
      if (trace.external) continue;  // which need not have our grids
      if (!on_grid(x, sim::PositionGrid::kStep) || !on_grid(v, sim::VelocityGrid::kStep) ||
          !on_grid(w, sim::VelocityGrid::kStep))
        return broken(k, bodies.id[i], "a value lies off its grid, or is a negative zero");
    }
  }
  return held();
}

Judgement judge_momentum(const Trace& trace) {
  if (trace.scene.world.air_drag != 0) return not_applicable("air takes momentum");
  Worst worst("kg m/s");
  bool any = false;
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    const Bodies &begun = trace.begun(k).bodies, &after = trace.after(k).bodies;
    const Vec3 gravity = trace.begun(k).def.gravity;
    if (trace.scene.world.method == sim::Method::kThesis && length(gravity) > 0) continue;  // a lift is paid for
    for (const TouchingGroup& group : groups_of(trace, k)) {
      if (group.fixed || is_parted(trace.begun(k), group.bodies)) continue;
      any = true;
      const Momentum from = momentum_of(begun, group.bodies), to = momentum_of(after, group.bodies);
      const Vec3 off = to.linear - from.linear - gravity * (from.mass * trace.steps[k].dt);
      double scale = 0;
      for (const sim::BodyId id : group.bodies) {
        const BodyIndex i = *begun.find(id);
        scale += begun.mass[i] * (length(begun.velocity[i]) + length(gravity) * trace.steps[k].dt);
        scale += begun.mass[i] * length(begun.half_extent[i]) * length(begun.spin[i]);
      }
      // A pair that bounces in method layered waits where it met for the rest of the substep, and does not fall there.
      const double weight = from.mass * length(gravity) * trace.steps[k].dt;
      const Vec3 up = length(gravity) > 0 ? Vec3(gravity / length(gravity)) : Vec3(0, 0, 0);
      const double along = dot(off, up);
      const double rounding = (1e-9 + trace.rounding) * (scale + from.mass);
      worst.add(k + 1, group.bodies.front(), length(off - up * along), rounding, "momentum across gravity changed");
      worst.add(k + 1, group.bodies.front(), std::fabs(along), rounding + (group.bodies.size() > 1 ? weight : 0),
                "momentum along gravity changed");
    }
  }
  return any ? worst.judgement() : not_applicable("no bodies that touch nothing fixed");
}

Judgement judge_angular_momentum(const Trace& trace) {
  if (trace.scene.world.air_drag != 0) return not_applicable("air takes angular momentum");
  if (trace.scene.world.method == sim::Method::kThesis)
    return not_applicable("method thesis parts boxes without regard to their angular momentum");
  Worst worst("kg m2/s");
  bool any = false;
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    const Bodies &begun = trace.begun(k).bodies, &after = trace.after(k).bodies;
    if (length(trace.begun(k).def.gravity) > 0) continue;
    for (const TouchingGroup& group : groups_of(trace, k)) {
      if (group.fixed || is_parted(trace.begun(k), group.bodies)) continue;
      // Normals are those of the start of the step: nothing is claimed where a body turns far in a step.
      const bool meets = group.bodies.size() > 1;
      if (meets && std::ranges::any_of(group.bodies, [&](sim::BodyId id) {
            return length(begun.spin[*begun.find(id)]) * trace.steps[k].dt > kTurnMost;
          }))
        continue;
      any = true;
      const Momentum from = momentum_of(begun, group.bodies), to = momentum_of(after, group.bodies);
      // About the common centre, so that a place far away makes no rounding look large.
      const Vec3 centre = from.first / from.mass, moved = to.first / to.mass;
      const Vec3 off = (to.angular - cross(moved, to.linear)) - (from.angular - cross(centre, from.linear));
      const Vec3 common = from.linear / from.mass;
      double scale = 0, moved_on = 0;
      for (const sim::BodyId id : group.bodies) {
        const BodyIndex i = *begun.find(id), j = *after.find(id);
        const double speed = std::max(length(begun.velocity[i] - common), length(after.velocity[j] - common));
        moved_on += begun.mass[i] * length(after.velocity[j] - begun.velocity[i]) * speed * trace.steps[k].dt;
        const double reach = length(begun.position[i] - centre) + length(begun.half_extent[i]);
        scale += begun.mass[i] * reach * length(begun.velocity[i] - common);
        scale += length(spin_momentum(begun, i));
      }
      // Of three bodies, the third is hit where it lay when the first two met.
      const double late = group.bodies.size() > 2 ? moved_on : 0;
      worst.add(k + 1, group.bodies.front(), length(off), kAngularPart * scale + late + 1e-9 * from.mass,
                "angular momentum changed");
    }
  }
  return any ? worst.judgement() : not_applicable("no bodies without gravity that touch nothing fixed");
}

}  // namespace tumble::hunt
