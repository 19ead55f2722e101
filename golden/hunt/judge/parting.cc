// Boxes that begin inside one another. How they are parted shows where nothing else acts: the law takes the boxes of
// the scene at rest, without gravity, and judges that session.
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "golden/hunt/judge/bounds.h"
#include "golden/hunt/judge/laws.h"
#include "golden/hunt/judge/mechanics.h"

namespace tumble::hunt {
namespace {

using sim::Bodies;
using sim::BodyIndex;
using sim::cross;
using sim::dot;
using sim::length;
using sim::Vec3;

constexpr std::uint64_t kPartingSteps = 60;

sim::SceneDef at_rest(sim::SceneDef scene) {
  scene.inputs.clear();
  scene.world.gravity = {0, 0, 0};
  scene.world.freezing = false;
  scene.steps = std::min(scene.steps, kPartingSteps);
  for (sim::BoxDef& box : scene.boxes) {
    box.velocity = box.spin = {0, 0, 0};
    box.frozen = false;
  }
  return scene;
}

// What begins at rest and is only parted is at rest.
void add_speeds(const Trace& trace, std::size_t k, Worst& worst) {
  const Bodies& after = trace.after(k).bodies;
  for (BodyIndex i = 0; i < after.size(); ++i) {
    const double speed = length(after.velocity[i]) + length(after.spin[i]) * half_diagonal(after, i);
    worst.add(k + 1, after.id[i], speed, kPartedSpeed, "boxes that begin inside one another at rest part with a speed");
  }
}

// Bodies share a way by their masses, so the common centre stays. Method thesis adds the ways of several overlaps.
void add_centres(const Trace& trace, std::size_t k, Worst& worst) {
  const Bodies &begun = trace.begun(k).bodies, &after = trace.after(k).bodies;
  const bool thesis = trace.scene.world.method == sim::Method::kThesis;
  for (const TouchingGroup& group : groups_of(trace, k)) {
    if (group.fixed || group.bodies.size() < 2 || (thesis && group.bodies.size() > 2)) continue;
    const Momentum from = momentum_of(begun, group.bodies), to = momentum_of(after, group.bodies);
    const Vec3 centre = from.first / from.mass;
    worst.add(k + 1, group.bodies.front(), length(Vec3(to.first / to.mass - centre)),
              kPartedCentre + trace.rounding * length(centre), "the common centre of boxes that part moved");
  }
}

double reach_along(const sim::BoxFrame& frame, const Vec3& direction) {
  double reach = 0;
  for (int k = 0; k < 3; ++k) reach += frame.half_extent[k] * std::fabs(dot(frame.axes[k], direction));
  return reach;
}

// Whether two boxes overlap least along a direction in which their centres agree: neither way out is shorter than the
// other. No method decides an exact tie, and such boxes may stay.
bool is_tie(const sim::BoxFrame& a, const sim::BoxFrame& b, double depth) {
  const Vec3 apart = b.position - a.position;
  std::vector<Vec3> directions;
  for (int i = 0; i < 3; ++i) {
    directions.insert(directions.end(), {a.axes[i], b.axes[i]});
    for (int j = 0; j < 3; ++j) directions.push_back(cross(a.axes[i], b.axes[j]));
  }
  return std::ranges::any_of(directions, [&](const Vec3& one) {
    const double size = length(one);
    if (size < 1e-6) return false;
    const Vec3 direction = one / size;
    const double along = std::fabs(dot(apart, direction));
    return along < kPartedError && reach_along(a, direction) + reach_along(b, direction) - along < depth + kPartedError;
  });
}

// Two boxes alone lie less deep in one another after each step.
void add_depths(const Trace& trace, std::size_t k, Worst& worst) {
  const sim::WorldState& begun = trace.begun(k);
  const bool thesis = begun.def.method == sim::Method::kThesis;
  std::map<Meeting, double> after;
  for (const Overlap& one : overlaps_of(trace.after(k))) after[std::minmax(one.a, one.b)] = one.depth;
  for (const Overlap& one : overlaps_of(begun)) {
    const Meeting pair = std::minmax(one.a, one.b);
    if (pair.first != kGroundId && is_tie(frame_of(begun.bodies, *begun.bodies.find(pair.first)),
                                          frame_of(begun.bodies, *begun.bodies.find(pair.second)), one.depth))
      continue;
    const auto is_one = [&pair](sim::BodyId id) { return id != kGroundId && (id == pair.first || id == pair.second); };
    const auto is_other = [&](const Meeting& other) {
      return other != pair && (is_one(other.first) || is_one(other.second));
    };
    if (std::ranges::any_of(trace.steps[k].met, is_other)) continue;
    const double most = kPartSpeed * trace.steps[k].dt;
    const double part = thesis ? one.depth : std::clamp((one.depth - kPartedSurely) / 3, 0.0, most);
    worst.add(k + 1, pair.second, after[pair], one.depth - kPartedLeast * part + kPartedError, "boxes are not parted");
  }
}

}  // namespace

Judgement judge_parting(const Trace& trace) {
  if (worst_overlap(trace.states[0]).depth <= kBeginApart) return not_applicable("no boxes begin inside one another");
  const Result<Trace> parted = trace.again(at_rest(trace.scene));
  if (!parted.ok()) return not_applicable("the boxes at rest are no scene: " + parted.error().message);
  if (!parted->failure.empty()) return broken(parted->states.size(), 0, "parting ends early: " + parted->failure);
  Worst speed("m/s"), centre("m"), depth("m");
  for (std::size_t k = 0; k < parted->steps.size(); ++k) {
    add_speeds(*parted, k, speed);
    add_centres(*parted, k, centre);
    add_depths(*parted, k, depth);
  }
  for (const Worst& one : {speed, centre}) {
    if (one.is_broken()) return one.judgement();
  }
  return depth.judgement();
}

}  // namespace tumble::hunt
