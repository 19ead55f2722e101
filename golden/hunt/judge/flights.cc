// Laws of bodies that meet nothing.
#include <algorithm>
#include <cmath>

#include "golden/hunt/judge/laws.h"
#include "golden/hunt/judge/mechanics.h"
#include "golden/hunt/judge/unmet.h"

namespace tumble::hunt {
namespace {

using sim::Bodies;
using sim::BodyIndex;
using sim::length;
using sim::Vec3;

// Calls visit(step, row before, row after) for each body that surely met nothing in a step.
template <class Visit>
bool for_unmet(const Trace& trace, Visit visit) {
  bool any = false;
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    const std::vector<std::uint8_t> unmet = surely_unmet(trace, k);
    const Bodies &begun = trace.begun(k).bodies, &after = trace.after(k).bodies;
    for (BodyIndex i = 0; i < begun.size(); ++i) {
      const auto j = after.find(begun.id[i]);
      if (unmet[i] == 0 || !j || !after.moves(*j)) continue;
      any = true;
      visit(k, i, *j);
    }
  }
  return any;
}

bool listed(const TracedStep& step, sim::BodyId id) {
  return std::ranges::any_of(step.met, [id](const Meeting& pair) { return pair.first == id || pair.second == id; });
}

}  // namespace

Judgement judge_unmet(const Trace& trace) {
  if (trace.scene.world.air_drag != 0) return not_applicable("air slows bodies down");
  Worst worst("");
  const bool any = for_unmet(trace, [&](std::size_t k, BodyIndex i, BodyIndex j) {
    const Bodies &begun = trace.begun(k).bodies, &after = trace.after(k).bodies;
    const Vec3 fall = trace.begun(k).def.gravity * trace.steps[k].dt;
    const double off = length(after.velocity[j] - (begun.velocity[i] + fall));
    worst.add(k + 1, begun.id[i], off, 1e-9 + (1e-12 + trace.rounding) * (length(begun.velocity[i]) + length(fall)),
              "a body that meets nothing changed its velocity (m/s)");
    const double turned = length(spin_momentum(after, j) - spin_momentum(begun, i));
    const double least = moments_of(begun, i).minCoeff();
    worst.add(k + 1, begun.id[i], turned, (1e-6 + trace.rounding) * length(spin_momentum(begun, i)) + 1e-9 * least,
              "a body that meets nothing changed its angular momentum (kg·m²/s)");
  });
  return any ? worst.judgement() : not_applicable("no body is surely far from all others");
}

Judgement judge_flight(const Trace& trace) {
  if (trace.scene.world.air_drag != 0) return not_applicable("air slows bodies down");
  Worst worst("");
  bool any = false;
  for_unmet(trace, [&](std::size_t k, BodyIndex i, BodyIndex j) {
    const Bodies &begun = trace.begun(k).bodies, &after = trace.after(k).bodies;
    if (listed(trace.steps[k], begun.id[i])) return;
    any = true;
    const double dt = trace.steps[k].dt;
    const Vec3 wanted =
        begun.position[i] + (begun.velocity[i] + trace.begun(k).def.gravity * (0.5 * dt * trace.fall)) * dt;
    worst.add(k + 1, begun.id[i], length(after.position[j] - wanted), 1e-9 + trace.rounding * length(wanted),
              "a free body left its parabola (m)");
    const double before = spin_energy(begun, i), now = spin_energy(after, j);
    worst.add(k + 1, begun.id[i], std::fabs(now - before),
              (1e-6 + trace.rounding) * before + 1e-12 * moments_of(begun, i).maxCoeff(),
              "a free body's energy of rotation changed (J)");
  });
  return any ? worst.judgement() : not_applicable("no body is surely far from all others");
}

}  // namespace tumble::hunt
