// The law of energy, for all bodies together.
#include <algorithm>
#include <cmath>
#include <limits>

#include "golden/hunt/judge/bounds.h"
#include "golden/hunt/judge/laws.h"
#include "golden/hunt/judge/mechanics.h"

namespace tumble::hunt {
namespace {

using sim::BodyIndex;
using sim::length;

double mass_that_moves(const sim::WorldState& state) {
  double mass = 0;
  for (BodyIndex i = 0; i < state.bodies.size(); ++i) {
    if (state.bodies.is_static[i] == 0) mass += state.bodies.mass[i];
  }
  return mass;
}

// J that a step may add by moving overlapping boxes apart: what moves one box out of another against gravity, and with
// it, in method layered, all that may lie on it. What the lifted body cannot pay with its speed stays (docs/step.md,
// "Two limits remain"; docs/thesis.md, "Lifts that cannot be paid").
double lift_of(const Trace& trace, std::size_t k) {
  const sim::WorldState& begun = trace.begun(k);
  const double g = length(begun.def.gravity);
  double lift = 0;
  if (begun.def.method == sim::Method::kThesis) {
    const auto mass_of = [&begun](sim::BodyId id) {
      const auto i = begun.bodies.find(id);
      return i && begun.bodies.moves(*i) ? begun.bodies.mass[*i] : std::numeric_limits<double>::infinity();
    };
    // Two bodies share the way by their masses, and one of them goes down.
    for (const ContactForce& force : trace.steps[k].forces) {
      const double a = mass_of(force.a), b = mass_of(force.b);
      if (std::isinf(a) && std::isinf(b)) continue;
      lift += force.depth * g / (1 / a + 1 / b);
    }
    return lift;
  }
  for (const Overlap& overlap : overlaps_of(begun)) {
    const double slack = std::min(kPartSlack, kPartSlackPart * overlap.thinnest);
    lift += std::clamp((overlap.depth - slack) / 3, 0.0, kPartSpeed * trace.steps[k].dt);
  }
  return lift * mass_that_moves(begun) * g;
}

}  // namespace

Judgement judge_energy(const Trace& trace) {
  if (!begins_apart(trace, kBeginApart)) return not_applicable("boxes begin inside one another");
  if (trace.external && trace.scene.world.method == sim::Method::kThesis)
    return not_applicable("what the overlaps were that were parted is not known");
  Worst worst("J");
  double lowest = std::numeric_limits<double>::infinity(), put_in = 0, kinetic_most = 0, lifted = 0;
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    const auto energy_of = [&](const sim::WorldState& state) {
      const sim::Energy energy = total_energy(state);
      kinetic_most = std::max(kinetic_most, energy.kinetic);
      return energy.kinetic + energy.potential;
    };
    const double before = energy_of(trace.begun(k));
    put_in += before - (energy_of(trace.before(k)));
    const auto lower = [&](double energy) {
      if (energy >= lowest) return;
      lowest = energy;
      lifted = 0;
    };
    lower(before - put_in);
    lifted += lift_of(trace, k);
    const double after = energy_of(trace.after(k)) - put_in;
    const double weight = mass_that_moves(trace.after(k)) * length(trace.after(k).def.gravity);
    worst.add(k + 1, 0, after - lowest, kEnergyPart * kinetic_most + kPlaceError * weight + lifted,
              "energy was gained");
    lower(after);
  }
  return worst.judgement();
}

}  // namespace tumble::hunt
