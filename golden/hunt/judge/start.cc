// State 0 against the scene.
#include <cmath>

#include "golden/hunt/judge/laws.h"
#include "golden/hunt/judge/mechanics.h"
#include "src/math/grid.h"

namespace tumble::hunt {
namespace {

using sim::Bodies;
using sim::BodyIndex;
using sim::Vec3;

bool near(const Vec3& a, const Vec3& b, double most) { return (a - b).cwiseAbs().maxCoeff() <= most; }

// What differs between a body and its definition; null: nothing.
const char* other_than(const sim::BoxDef& box, const Bodies& bodies, BodyIndex i) {
  if (bodies.mass[i] != box.mass) return "mass";
  if (bodies.half_extent[i] != Vec3(box.size * 0.5)) return "size";
  if ((bodies.is_static[i] != 0) != box.is_static) return "being static";
  if (!near(bodies.position[i], box.position, sim::PositionGrid::kStep)) return "position";
  const bool rests = box.is_static || box.frozen;
  if (!near(bodies.velocity[i], rests ? Vec3(0, 0, 0) : box.velocity, sim::VelocityGrid::kStep)) return "velocity";
  if (!near(bodies.spin[i], rests ? Vec3(0, 0, 0) : box.spin, sim::VelocityGrid::kStep)) return "spin";
  const sim::Material& material = box.material;
  if (bodies.friction[i] != material.friction || bodies.friction_dynamic[i] != material.friction_dynamic)
    return "friction";
  if (bodies.restitution[i] != material.restitution) return "restitution";
  if (box.is_static) return nullptr;
  const Vec3 moments = moments_of(bodies, i);
  if (!near(bodies.inertia[i], moments, 1e-12 * moments.maxCoeff())) return "moments of inertia";
  const Vec3 one = bodies.inertia[i].cwiseProduct(bodies.inverse_inertia[i]);
  if (!near(one, {1, 1, 1}, 1e-12) || std::fabs(bodies.mass[i] * bodies.inverse_mass[i] - 1) > 1e-12)
    return "inverse of mass or inertia";
  return nullptr;
}

}  // namespace

Judgement judge_start(const Trace& trace) {
  const sim::WorldState& state = trace.states[0];
  if (!(state.def == trace.scene.world)) return broken(0, 0, "state 0 has other settings than the scene");
  for (const sim::BoxDef& box : trace.scene.boxes) {
    const auto i = state.bodies.find(box.id);
    const char* what = i ? other_than(box, state.bodies, *i) : "existence";
    if (what != nullptr) return broken(0, box.id, std::string("state 0 differs from the scene in ") + what);
  }
  return held();
}

}  // namespace tumble::hunt
