// Laws with a formula for the whole session: one crate on a slope, one box dropped flat, a stack at rest, free flights.
#include <algorithm>
#include <cmath>
#include <span>

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

constexpr double kDtMost = 1.0 / 30 + 1e-9;  // s; the formulas are promised up to this step
constexpr double kClear = 0.02;              // slopes nearer than this to a coefficient of friction are left out

bool plain(const Trace& trace) {
  const sim::WorldDef& world = trace.scene.world;
  return trace.scene.inputs.empty() && world.air_drag == 0 && world.dt <= kDtMost && world.ground;
}

bool upright(const sim::BoxDef& box) { return box.orientation == sim::Quat{} && box.spin == Vec3(0, 0, 0); }

struct PairFriction {
  double fixed = 0, sliding = 0;
};
PairFriction friction_of(const sim::SceneDef& scene) {
  const sim::Material &a = scene.boxes[0].material, &b = scene.world.ground_material;
  return {std::sqrt(a.friction * b.friction), std::sqrt(a.friction_dynamic * b.friction_dynamic)};
}

// Why Coulomb's formula says nothing of a scene; empty: it does.
std::string no_slope(const Trace& trace) {
  const sim::SceneDef& scene = trace.scene;
  if (!plain(trace) || scene.boxes.size() != 1 || scene.boxes[0].is_static || scene.boxes[0].frozen)
    return "not one crate alone on the ground";
  const sim::BoxDef& box = scene.boxes[0];
  const Vec3 g = scene.world.gravity, along(g.x(), g.y(), 0);
  if (!upright(box) || std::fabs(box.position.z() - 0.5 * box.size.z()) > 1e-6) return "the crate does not lie flat";
  if (std::min(box.size.x(), box.size.y()) < 2 * box.size.z()) return "the crate may tip";
  if (!(g.z() < 0) || !(length(along) > 0)) return "the ground does not slope";
  if (!(friction_of(scene).fixed <= 1)) return "more friction than the formula is promised for";
  if (box.velocity.z() != 0 || length(cross(box.velocity, along)) > 1e-9 || dot(box.velocity, along) < 0)
    return "the crate does not start down the slope";
  const double slope = length(along) / -g.z(), speed = length(box.velocity);
  const PairFriction friction = friction_of(scene);
  if (std::fabs(slope - friction.fixed) < kClear) return "too near to the angle of friction";
  if (speed > 0 && std::fabs(slope - friction.sliding) < kClear) return "too near to the angle of friction";
  return {};
}

// m that method layered is off by: it moves a body by its speed at the end of a substep, so a body goes half a
// substep's way too far or too short, and static friction holds a body that it can stop within one substep
// (docs/step.md).
double half_a_substep(const sim::SceneDef& scene, double speed, double braking, double held, bool rests) {
  if (scene.world.method == sim::Method::kThesis) return 0;
  const bool few = scene.world.substeps < 4 && rests && speed > 0 && braking > 0;
  return 0.5 * speed * (scene.world.dt / scene.world.substeps) + (few ? held * held / (2 * braking) : 0);
}

// Height of the lowest face over the ground; 0 where the box does not fall freely and flat.
double falls_flat(const Trace& trace) {
  const sim::SceneDef& scene = trace.scene;
  if (!plain(trace) || scene.boxes.size() != 1 || scene.boxes[0].is_static || scene.boxes[0].frozen) return 0;
  const sim::BoxDef& box = scene.boxes[0];
  const Vec3 g = scene.world.gravity;
  if (!upright(box) || box.velocity != Vec3(0, 0, 0) || g.x() != 0 || g.y() != 0 || !(g.z() < 0)) return 0;
  return box.position.z() - 0.5 * box.size.z();
}

// m/s that method thesis may take from a box that leaves the ground: it pays with its speed for the way out of the
// ground, at most the way that it came in one step, m.
double lift_paid(const Trace& trace, double speed, double way) {
  if (trace.scene.world.method != sim::Method::kThesis) return 0;
  const double left = speed * speed - 2 * length(trace.scene.world.gravity) * way;
  return speed - std::sqrt(std::max(left, 0.0));
}

}  // namespace

Judgement judge_slope(const Trace& trace) {
  if (std::string why = no_slope(trace); !why.empty()) return not_applicable(std::move(why));
  const sim::SceneDef& scene = trace.scene;
  const Vec3 g = scene.world.gravity, along(g.x(), g.y(), 0);
  const double down = length(along), press = -g.z(), speed = length(scene.boxes[0].velocity);
  const PairFriction friction = friction_of(scene);
  const bool stays = speed == 0 && down / press < friction.fixed;
  const double gain = stays ? 0 : down - friction.sliding * press;
  const double held = (friction.fixed * press - down) * scene.world.dt / scene.world.substeps;
  Worst worst("m");
  double time = 0;
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    time += trace.steps[k].dt;
    const double moving = gain < 0 ? std::min(time, -speed / gain) : time;
    const bool rests = gain < 0 && moving < time;
    // Freezing takes a crate this slow to be at rest, whatever the slope (docs/scenes.md).
    const double pace = stays || rests ? 0 : speed + gain * moving;
    if (trace.after(k).bodies.frozen[0] != 0 && pace > 0 && 0.5 * pace * pace < scene.world.freeze_energy) break;
    const double metres = stays ? 0 : speed * moving + 0.5 * gain * moving * moving;
    const Vec3 off = trace.after(k).bodies.position[0] - trace.states[0].bodies.position[0] - along * (metres / down);
    worst.add(k + 1, scene.boxes[0].id, length(off),
              std::max(0.001, 0.02 * metres) +
                  half_a_substep(scene, std::max(speed, speed + gain * moving), -gain, held, rests),
              "the crate is not where Coulomb says");
  }
  return worst.judgement();
}

Judgement judge_bounce(const Trace& trace) {
  const double height = falls_flat(trace), g = length(trace.scene.world.gravity);
  if (!(height > 0.01)) return not_applicable("not one box that falls flat");
  const sim::SceneDef& scene = trace.scene;
  const double restitution = std::max(scene.boxes[0].material.restitution, scene.world.ground_material.restitution);
  const double impact = std::sqrt(2 * g * height), wanted = restitution * impact, dt = scene.world.dt;
  if (!(wanted > 1)) return not_applicable("the box bounces with less than 1 m/s");
  if (static_cast<double>(trace.steps.size()) * dt < impact / g + 3 * dt)
    return not_applicable("the box does not land");
  const double bound = 2 * g * dt + 0.02 * impact + lift_paid(trace, wanted, impact * dt);
  if (!(wanted > bound)) return not_applicable("what the box pays for its lift may take the bounce");
  Worst worst("m/s");
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    const double up = trace.after(k).bodies.velocity.z[0];
    if (up > 0) {
      worst.add(k + 1, scene.boxes[0].id, std::fabs(up - wanted), bound, "the bounce is not that of the restitution");
      return worst.judgement();
    }
  }
  return broken(trace.steps.size(), scene.boxes[0].id, "the box landed and did not bounce", wanted, bound, "m/s");
}

namespace {

// The boxes of a stack from below, or none: each rests exactly on the one below, and nothing moves.
std::vector<const sim::BoxDef*> stack_of(const Trace& trace) {
  const sim::SceneDef& scene = trace.scene;
  const Vec3 g = scene.world.gravity;
  if (!plain(trace) || scene.world.method != sim::Method::kLayered || g.x() != 0 || g.y() != 0 || !(g.z() < 0))
    return {};
  std::vector<const sim::BoxDef*> stack;
  for (const sim::BoxDef& box : scene.boxes) {
    if (!upright(box) || box.velocity != Vec3(0, 0, 0) || box.is_static) return {};
    stack.push_back(&box);
  }
  std::ranges::sort(stack, {}, [](const sim::BoxDef* box) { return box->position.z(); });
  double top = 0;
  for (const sim::BoxDef* box : stack) {
    if (std::fabs(box->position.z() - 0.5 * box->size.z() - top) > 1e-9) return {};
    top = box->position.z() + 0.5 * box->size.z();
  }
  return stack;
}

// Whether everything from box k up has its centre of mass well above the face on which it stands.
bool stands(const std::vector<const sim::BoxDef*>& stack, std::size_t k) {
  Vec3 sum(0, 0, 0);
  double mass = 0;
  for (std::size_t i = k; i < stack.size(); ++i) {
    sum += stack[i]->position * stack[i]->mass;
    mass += stack[i]->mass;
  }
  const Vec3 centre = sum / mass;
  for (int axis = 0; axis < 2; ++axis) {
    double low = stack[k]->position[axis] - 0.5 * stack[k]->size[axis];
    double high = stack[k]->position[axis] + 0.5 * stack[k]->size[axis];
    if (k > 0) {
      low = std::max(low, stack[k - 1]->position[axis] - 0.5 * stack[k - 1]->size[axis]);
      high = std::min(high, stack[k - 1]->position[axis] + 0.5 * stack[k - 1]->size[axis]);
    }
    const double margin = kStandMargin * (high - low);
    if (!(centre[axis] > low + margin && centre[axis] < high - margin)) return false;
  }
  return true;
}

}  // namespace

Judgement judge_standing(const Trace& trace) {
  const std::vector<const sim::BoxDef*> stack = stack_of(trace);
  if (stack.empty()) return not_applicable("no stack at rest, of method layered");
  double least = stack[0]->mass, most = least;
  for (std::size_t k = 0; k < stack.size(); ++k) {
    least = std::min(least, stack[k]->mass);
    most = std::max(most, stack[k]->mass);
    if (!stands(stack, k)) return not_applicable("the stack may fall");
  }
  if (most > kStandRatio * least) return not_applicable("masses too different to promise anything");
  Worst worst("m");
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    const Bodies &now = trace.after(k).bodies, &start = trace.states[0].bodies;
    for (BodyIndex i = 0; i < now.size(); ++i) {
      worst.add(k + 1, now.id[i], length(now.position[i] - start.position[i]), kStandDrift, "a stack at rest moved");
    }
  }
  return worst.judgement();
}

namespace {

bool only_flies(const Trace& trace) {
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    if (!trace.steps[k].met.empty() || trace.before(k).bodies.frozen != trace.after(k).bodies.frozen) return false;
  }
  return true;
}

// How far apart an integrator that leaves the parabola ends a flight with half of dt.
Vec3 apart_by_integrator(const Trace& trace, sim::BodyId id) {
  Vec3 fallen(0, 0, 0);
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    const sim::WorldState& begun = trace.begun(k);
    const auto i = begun.bodies.find(id);
    if (i && begun.bodies.moves(*i)) fallen += begun.def.gravity * (trace.steps[k].dt * trace.steps[k].dt);
  }
  return fallen * (0.25 * (1 - trace.fall));
}

// How many times an error of a free turn grows: the motion about the middle axis is unstable, and the time that a body
// takes from one turning over to the next goes with the logarithm of how far its energy is from that of this motion.
double growth_of_turn(const Bodies& bodies, BodyIndex i) {
  Vec3 moments = moments_of(bodies, i);
  std::ranges::sort(std::span(moments.data(), 3));
  const Vec3 momentum = spin_momentum(bodies, i);
  const double squared = dot(momentum, momentum);
  if (!(squared > 0) || moments[0] == moments[1] || moments[1] == moments[2]) return 1;
  return 1 / std::min(1.0, std::fabs(2 * spin_energy(bodies, i) * moments[1] / squared - 1));
}

}  // namespace

Judgement judge_halved(const Trace& trace) {
  if (trace.scene.world.air_drag != 0) return not_applicable("air slows bodies down");
  if (!only_flies(trace)) return not_applicable("something touches, freezes or wakes");
  sim::SceneDef halved = trace.scene;
  halved.world.dt *= 0.5;
  halved.steps = 2 * trace.steps.size();
  for (sim::TimedCommand& input : halved.inputs) {
    input.step = 2 * input.step - 1;
    if (auto* set = std::get_if<sim::SetDt>(&input.command)) set->dt *= 0.5;
  }
  const Result<Trace> other = trace.again(halved);
  if (!other.ok() || !other->failure.empty()) return not_applicable("half of dt is no session");
  if (!only_flies(*other)) return not_applicable("something touches with half of dt");
  const Bodies &one = trace.states.back().bodies, &two = other->states.back().bodies;
  if (one.id != two.id) return broken(trace.steps.size(), 0, "other bodies are left");
  double time = 0, most = 0;
  for (const TracedStep& step : trace.steps) time += step.dt;
  for (const sim::WorldState& state : trace.states) {
    for (BodyIndex i = 0; i < state.bodies.size(); ++i) most = std::max(most, length(state.bodies.spin[i]));
  }
  Worst worst("");
  for (BodyIndex i = 0; i < one.size(); ++i) {
    const Vec3 apart = two.position[i] - one.position[i] - apart_by_integrator(trace, one.id[i]);
    worst.add(trace.steps.size(), one.id[i], length(apart),
              1e-8 + trace.rounding * length(one.position[i]) * static_cast<double>(trace.steps.size()),
              "a flight ends elsewhere with half of dt (m)");
    const sim::Quat p = one.orientation[i], q = two.orientation[i];
    const double cosine = std::fabs(p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z);
    const double bound = kTurnPart * most * time * growth_of_turn(one, i) + 1e-7;
    if (!(bound < kTurnBoundMost)) continue;  // a turn that no error bounds
    worst.add(trace.steps.size(), one.id[i], 2 * std::sqrt(std::max(0.0, 2 * (1 - cosine))), bound,
              "a flight ends turned otherwise with half of dt (rad)");
  }
  return worst.judgement();
}

}  // namespace tumble::hunt
