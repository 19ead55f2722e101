#include "golden/hunt/judge/laws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "golden/hunt/judge/bounds.h"
#include "golden/hunt/judge/mechanics.h"
#include "replay/measure/measure_overlap.h"
#include "src/math/grid.h"

namespace tumble::hunt {
namespace {

using sim::Bodies;
using sim::BodyIndex;
using sim::cross;
using sim::dot;
using sim::length;
using sim::Vec3;

constexpr double kApart = 1e-3;  // m; boxes that begin deeper in one another gain energy by being parted

bool finite(const Vec3& v) { return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z()); }
bool on_grid(const Vec3& v, double step) {
  return std::ranges::all_of(std::array{v.x(), v.y(), v.z()}, [step](double x) {
    return x / step == std::floor(x / step) && !(x == 0 && std::signbit(x));
  });
}

// Whether a box of these begins a step so deep in something that the step lifts it out, and lets it pay with its speed.
bool is_parted(const sim::WorldState& state, const std::vector<sim::BodyId>& ids) {
  for (const sim::BodyId id : ids) {
    const auto i = state.bodies.find(id);
    if (!i) continue;
    const sim::BoxFrame frame = frame_of(state.bodies, *i);
    const double thin = frame.half_extent.minCoeff();
    if (state.def.ground && replay::ground_penetration(frame) > std::min(kPartedDepth, kPartedPart * thin)) return true;
    for (BodyIndex j = 0; j < state.bodies.size(); ++j) {
      if (j == *i) continue;
      const double depth = std::min(kPartedDepth, kPartedPart * std::min(thin, state.bodies.half_extent[j].minCoeff()));
      if (replay::overlap_depth(frame, frame_of(state.bodies, j)) > depth) return true;
    }
  }
  return false;
}

// Kinetic energy and lift of everything by a little: what an error of energy is measured against.
double energy_bound(const sim::WorldState& state, double kinetic_most) {
  double weight = 0;
  for (BodyIndex i = 0; i < state.bodies.size(); ++i) {
    if (state.bodies.is_static[i] == 0) weight += state.bodies.mass[i] * length(state.def.gravity);
  }
  return kEnergyPart * kinetic_most + weight * kLift.of(state.def.method);
}

}  // namespace

void Worst::add(std::uint64_t step, sim::BodyId body, double value, double bound, const char* what) {
  if (is_broken()) return;
  const bool breaks = !(value <= bound);
  const bool nearer = worst_.bound <= 0 || value * worst_.bound > worst_.value * bound;
  if (!breaks && !nearer) return;
  worst_ = broken(step, body, what, value, bound, unit_);
  if (!breaks) worst_.outcome = Outcome::kHeld;
}

Judgement judge_finishes(const Trace& trace) {
  if (trace.failure.empty()) return held();
  return broken(trace.states.size(), 0, "the session ends early: " + trace.failure);
}

Judgement judge_numbers(const Trace& trace) {
  for (std::size_t k = 0; k < trace.states.size(); ++k) {
    const Bodies& bodies = trace.states[k].bodies;
    for (BodyIndex i = 0; i < bodies.size(); ++i) {
      const Vec3 x = bodies.position[i], v = bodies.velocity[i], w = bodies.spin[i];
      const double off = std::fabs(squared_length(bodies.orientation[i]) - 1);
      if (!finite(x) || !finite(v) || !finite(w) || !(off <= 1e-12))
        return broken(k, bodies.id[i], "a value is no number, or an orientation has not unit length", off, 1e-12);
      if (!on_grid(x, sim::PositionGrid::kStep) || !on_grid(v, sim::VelocityGrid::kStep) ||
          !on_grid(w, sim::VelocityGrid::kStep))
        return broken(k, bodies.id[i], "a value lies off its grid, or is a negative zero");
    }
  }
  return held();
}

Judgement judge_energy(const Trace& trace) {
  if (!begins_apart(trace, kApart)) return not_applicable("boxes begin inside one another");
  Worst worst("J");
  double lowest = std::numeric_limits<double>::infinity(), put_in = 0, kinetic_most = 0;
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    const auto energy_of = [&](const sim::WorldState& state) {
      const sim::Energy energy = total_energy(state);
      kinetic_most = std::max(kinetic_most, energy.kinetic);
      return energy.kinetic + energy.potential;
    };
    const double before = energy_of(trace.begun(k));
    put_in += before - (energy_of(trace.before(k)));
    lowest = std::min(lowest, before - put_in);
    const double after = energy_of(trace.after(k)) - put_in;
    worst.add(k + 1, 0, after - lowest, energy_bound(trace.after(k), kinetic_most), "energy was gained");
    lowest = std::min(lowest, after);
  }
  return worst.judgement();
}

Judgement judge_momentum(const Trace& trace) {
  if (trace.scene.world.air_drag != 0) return not_applicable("air takes momentum");
  Worst worst("kg m/s");
  bool any = false;
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    const Bodies &begun = trace.begun(k).bodies, &after = trace.after(k).bodies;
    const Vec3 gravity = trace.begun(k).def.gravity;
    if (trace.scene.world.method == sim::Method::kThesis && length(gravity) > 0) continue;  // a lift is paid for
    for (const Group& group : groups_of(trace, k)) {
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
      const double rounding = 1e-9 * scale + 1e-9 * from.mass;
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
    for (const Group& group : groups_of(trace, k)) {
      if (group.fixed || is_parted(trace.begun(k), group.bodies)) continue;
      any = true;
      const Momentum from = momentum_of(begun, group.bodies), to = momentum_of(after, group.bodies);
      // About the common centre, so that a place far away makes no rounding look large.
      const Vec3 centre = from.first / from.mass, moved = to.first / to.mass;
      const Vec3 off = (to.angular - cross(moved, to.linear)) - (from.angular - cross(centre, from.linear));
      double scale = 0;
      for (const sim::BodyId id : group.bodies) {
        const BodyIndex i = *begun.find(id);
        const double reach = length(begun.position[i] - centre) + length(begun.half_extent[i]);
        scale += begun.mass[i] * reach * length(begun.velocity[i] - from.linear / from.mass);
        scale += length(spin_momentum(begun, i));
      }
      worst.add(k + 1, group.bodies.front(), length(off), kAngularPart * scale + 1e-9 * from.mass,
                "angular momentum changed");
    }
  }
  return any ? worst.judgement() : not_applicable("no bodies without gravity that touch nothing fixed");
}

namespace {

double friction_of(const sim::WorldState& state, sim::BodyId id) {
  if (id == kGroundId) return std::max(state.def.ground_material.friction, state.def.ground_material.friction_dynamic);
  const BodyIndex i = *state.bodies.find(id);
  return std::max(state.bodies.friction[i], state.bodies.friction_dynamic[i]);
}

// Bodies that met the ground and nothing else in a step: what changed their momentum is the ground's impulse.
bool add_ground_impulses(const Trace& trace, std::size_t k, Worst& worst) {
  const sim::WorldState& begun = trace.begun(k);
  const Bodies& after = trace.after(k).bodies;
  bool any = false;
  for (const Meeting& meeting : trace.steps[k].met) {
    if (meeting.first != kGroundId) continue;
    const auto others = std::ranges::count_if(trace.steps[k].met, [&](const Meeting& other) {
      return other.first == meeting.second || other.second == meeting.second;
    });
    const auto i = begun.bodies.find(meeting.second), j = after.find(meeting.second);
    if (others != 1 || !i || !j || !begun.bodies.moves(*i) || !after.moves(*j)) continue;
    if (is_parted(begun, {meeting.second})) continue;
    any = true;
    const Vec3 fall = begun.def.gravity * trace.steps[k].dt;
    const Vec3 impulse = (after.velocity[*j] - begun.bodies.velocity[*i] - fall) * begun.bodies.mass[*i];
    const double across = length(Vec3(impulse.x(), impulse.y(), 0)), up = std::max(0.0, impulse.z());
    const double limit = std::sqrt(friction_of(begun, kGroundId) * friction_of(begun, meeting.second)) * up;
    // A body that bounces waits for the rest of the substep, and gravity that leans does not act there.
    const double waiting = length(Vec3(fall.x(), fall.y(), 0)) * begun.bodies.mass[*i];
    worst.add(k + 1, meeting.second, across, limit + kConePart * up + waiting + 1e-9 * begun.bodies.mass[*i],
              "the ground's impulse is outside Coulomb's cone");
  }
  return any;
}

}  // namespace

Judgement judge_cone(const Trace& trace) {
  if (trace.scene.world.air_drag != 0) return not_applicable("air slows bodies down");
  Worst worst("N s");
  bool any = false;
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    if (trace.scene.world.method == sim::Method::kLayered) {
      any |= add_ground_impulses(trace, k, worst);
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

Judgement judge_overlap(const Trace& trace) {
  if (!begins_apart(trace, kApart)) return not_applicable("boxes begin inside one another");
  Worst worst("m");
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    const Overlap overlap = worst_overlap(trace.after(k));
    worst.add(k + 1, std::max(overlap.a, overlap.b), overlap.depth,
              kOverlapPart.of(trace.scene.world.method) * overlap.thinnest + kOverlapLeast, "boxes overlap");
  }
  return worst.judgement();
}

}  // namespace tumble::hunt
