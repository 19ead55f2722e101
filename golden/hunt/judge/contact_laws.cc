// Laws of bodies that touch: Coulomb's cone, and overlaps.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "golden/hunt/judge/bounds.h"
#include "golden/hunt/judge/laws.h"
#include "golden/hunt/judge/mechanics.h"

namespace tumble::hunt {
namespace {

using sim::Bodies;
using sim::BodyIndex;
using sim::length;
using sim::Vec3;

double friction_of(const sim::WorldState& state, sim::BodyId id) {
  if (id == kGroundId) return std::max(state.def.ground_material.friction, state.def.ground_material.friction_dynamic);
  const BodyIndex i = *state.bodies.find(id);
  return std::max(state.bodies.friction[i], state.bodies.friction_dynamic[i]);
}

// Impulses along the normal by body, of those that met the ground and nothing else in a step.
using GroundImpulses = std::map<sim::BodyId, double>;

bool met_ground(const TracedStep& step, sim::BodyId id) {
  return std::ranges::find(step.met, Meeting{kGroundId, id}) != step.met.end();
}

// What changed the momentum of a body that met the ground alone is the ground's impulse.
GroundImpulses add_ground_impulses(const Trace& trace, std::size_t k, const GroundImpulses& before, Worst& worst) {
  const sim::WorldState& begun = trace.begun(k);
  const Bodies& after = trace.after(k).bodies;
  GroundImpulses found;
  for (const Meeting& meeting : trace.steps[k].met) {
    if (meeting.first != kGroundId) continue;
    const auto others = std::ranges::count_if(trace.steps[k].met, [&](const Meeting& other) {
      return other.first == meeting.second || other.second == meeting.second;
    });
    const auto i = begun.bodies.find(meeting.second), j = after.find(meeting.second);
    if (others != 1 || !i || !j || !begun.bodies.moves(*i) || !after.moves(*j)) continue;
    if (is_parted(begun, {meeting.second})) continue;
    const double mass = begun.bodies.mass[*i];
    const Vec3 fall = begun.def.gravity * trace.steps[k].dt;
    const Vec3 impulse = (after.velocity[*j] - begun.bodies.velocity[*i] - fall) * mass;
    const double across = length(Vec3(impulse.x(), impulse.y(), 0)), up = std::max(0.0, impulse.z());
    found[meeting.second] = up;
    // Where a body carries what it carried in the step before, friction and normals have found one another. Else the
    // last normals may be less than those that limited friction: by what friction itself takes off a corner, at most
    // kFrictionLifts of it, and, where the body leaves the ground, by what its contact started from: its weight, or
    // what it remembers of the step before.
    const auto last = before.find(meeting.second);
    const bool steady =
        up > kConeLoad * mass * length(fall) && last != before.end() && std::fabs(last->second - up) <= kConePart * up;
    double started = mass * length(fall);
    if (last != before.end())
      started += std::min(last->second, kRemembered * mass);
    else if (k > 0 && met_ground(trace.steps[k - 1], meeting.second))
      started += kRemembered * mass;
    const double coefficient = std::sqrt(friction_of(begun, kGroundId) * friction_of(begun, meeting.second));
    const double most = steady ? (1 + kConePart / std::max(coefficient, kConePart)) * up
                               : up / (1 - kFrictionLifts * std::min(coefficient, 1.0)) + started;
    // A body that bounces waits for the rest of the substep, and gravity that leans does not act there.
    const double waiting = length(Vec3(fall.x(), fall.y(), 0)) * mass;
    worst.add(k + 1, meeting.second, across,
              coefficient * most + waiting + (1e-9 + trace.rounding * length(after.velocity[*j])) * mass,
              "the ground's impulse is outside Coulomb's cone");
  }
  return found;
}

}  // namespace

Judgement judge_cone(const Trace& trace) {
  if (trace.scene.world.air_drag != 0) return not_applicable("air slows bodies down");
  Worst worst("N s");
  bool any = false;
  GroundImpulses before;
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    if (trace.scene.world.method == sim::Method::kLayered) {
      before = add_ground_impulses(trace, k, before, worst);
      any |= !before.empty();
      continue;
    }
    for (const ContactForce& force : trace.steps[k].forces) {
      any = true;
      const double limit =
          std::sqrt(friction_of(trace.begun(k), force.a) * friction_of(trace.begun(k), force.b)) * force.normal;
      worst.add(k + 1, std::max(force.a, force.b), force.tangent, limit + 1e-9 * force.normal + 1e-9,
                "friction is outside Coulomb's cone");
    }
  }
  return any ? worst.judgement() : not_applicable("nothing touched that can be judged alone");
}

namespace {

// m that two bodies can move against one another in a step by their motion in a state: by the speed between them, and
// where a third thing may stop one of them meanwhile, by the speed of each.
double travel_of(const Bodies& bodies, const Meeting& pair, double dt, bool are_alone) {
  Vec3 velocity(0, 0, 0);
  double turning = 0, each = 0;
  for (const auto& [id, sign] : {std::pair(pair.first, 1.0), {pair.second, -1.0}}) {
    const auto i = bodies.find(id);
    if (!i || !bodies.moves(*i)) continue;
    velocity += bodies.velocity[*i] * sign;
    each += length(bodies.velocity[*i]);
    turning += length(bodies.spin[*i]) * half_diagonal(bodies, *i);
  }
  return ((are_alone ? length(velocity) : each) + turning) * dt;
}

// Whether nothing but the other of the two met either of them in a step.
bool alone(const TracedStep& step, const Meeting& pair) {
  return std::ranges::none_of(step.met, [&pair](const Meeting& other) {
    const auto is_one = [&pair](sim::BodyId id) { return id != kGroundId && (id == pair.first || id == pair.second); };
    return other != pair && (is_one(other.first) || is_one(other.second));
  });
}

double ratio_of_masses(const Bodies& bodies, const std::vector<sim::BodyId>& ids) {
  double least = 0, most = 0;
  for (const sim::BodyId id : ids) {
    const double mass = bodies.mass[*bodies.find(id)];
    least = least == 0 ? mass : std::min(least, mass);
    most = std::max(most, mass);
  }
  return most / least;
}

double longest_substep(const Trace& trace) {
  double most = 0;
  for (const TracedStep& step : trace.steps) most = std::max(most, step.dt / trace.scene.world.substeps);
  return most;
}

}  // namespace

Judgement judge_overlap(const Trace& trace) {
  if (!begins_apart(trace, kBeginApart)) return not_applicable("boxes begin inside one another");
  const sim::Method method = trace.scene.world.method;
  const bool thesis = method == sim::Method::kThesis;
  if (!thesis && !trace.external && !(longest_substep(trace) <= kSubstepMost))
    return not_applicable("substeps too long to promise anything");
  Worst worst("m");
  // By pair: the most that the two could move against one another in a step since they began to overlap. Contacts are
  // found once a step, so a body that is hit moves to the end of the step into what it did not meet at its beginning.
  std::map<Meeting, double> left;
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    std::map<Meeting, double> now;
    std::set<sim::BodyId> uneven;
    for (const TouchingGroup& group : groups_of(trace, k)) {
      if (ratio_of_masses(trace.begun(k).bodies, group.bodies) > kOverlapRatio)
        uneven.insert(group.bodies.begin(), group.bodies.end());
    }
    for (const Overlap& overlap : overlaps_of(trace.after(k))) {
      const Meeting pair = std::minmax(overlap.a, overlap.b);
      const double dt = trace.steps[k].dt;
      const bool are_alone = alone(trace.steps[k], pair);
      const double travel = std::max(travel_of(trace.begun(k).bodies, pair, dt, are_alone),
                                     travel_of(trace.after(k).bodies, pair, dt, are_alone));
      now[pair] = std::max(travel, left.contains(pair) ? left[pair] : 0);
      if (uneven.contains(overlap.a) || uneven.contains(overlap.b) || (thesis && !are_alone)) {
        now[pair] = std::max(now[pair], overlap.depth);  // nothing is claimed, nor of what it leaves
        continue;
      }
      worst.add(k + 1, pair.second, overlap.depth,
                kOverlapPart.of(method) * overlap.thinnest + kOverlapLeast + now[pair], "boxes overlap");
    }
    left = std::move(now);
  }
  return worst.judgement();
}

}  // namespace tumble::hunt
