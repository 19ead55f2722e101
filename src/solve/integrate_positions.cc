#include "src/solve/integrate_positions.h"

#include "src/math/grid.h"
#include "src/solve/manifold_solver.h"
#include "src/solve/solver_body.h"
#include "src/world/body_check.h"

namespace tumble::sim {

Status integrate_positions(World& world, double substep_s) {
  Bodies& bodies = world.mutable_state().bodies;
  Scratch& scratch = world.mutable_scratch();
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (scratch.in_contact[i] == 0) continue;
    const SolverBody& body = scratch.solver_bodies[i];
    const Vec3 path = PositionGrid::round(Vec3(body.velocity * substep_s));
    bodies.position.set(i, plus_zero(bodies.position[i] + path));
    bodies.orientation.set(i, rotated_by_half(bodies.orientation[i], body.spin * (0.5 * substep_s)));
  }
  for (const std::uint32_t k : scratch.layered) {
    const Manifold& m = scratch.manifolds[k];
    const RelativeMotion motion = relative_motion(m, solver_body(scratch, m.a), solver_body(scratch, m.b));
    const double u = dot(motion.u, m.n), w1 = dot(motion.w, m.t1), w2 = dot(motion.w, m.t2);
    for (ManifoldPoint& point : points_of(scratch, m)) {
      point.separation += substep_s * (u + (w1 * point.q - w2 * point.p));
    }
  }
  return {};
}

void hash_integrate_positions(const World& world, Hasher& hasher) { hash_motion(world, hasher); }

}  // namespace tumble::sim
