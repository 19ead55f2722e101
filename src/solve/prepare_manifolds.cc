#include "src/solve/prepare_manifolds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/solve/contact_batches.h"
#include "src/solve/manifold_solver.h"
#include "src/solve/solver_body.h"

namespace tumble::sim {
namespace {

void prepare_bodies(World& world) {
  const Bodies& bodies = world.bodies();
  Scratch& scratch = world.mutable_scratch();
  const std::size_t n = bodies.size();
  scratch.solver_bodies.assign(n + 1, {});
  scratch.solver_sums.assign(n + 1, {});
  for (BodyIndex i = 0; i < n; ++i) {
    SolverBody& body = scratch.solver_bodies[i];
    if (bodies.moves(i)) {
      body.velocity = bodies.velocity[i];
      body.spin = bodies.spin[i];
      const double mass = scratch.solver_mass[i];
      const bool lent = mass != bodies.mass[i];
      body.weight = bodies.mass[i] / mass;
      body.inverse_mass = lent ? 1 / mass : bodies.inverse_mass[i];
      set_inverse_inertia(body, scratch.frames[i].axes, bodies.inverse_inertia[i] * body.weight);
    }
    scratch.solver_sums[i].velocity = body.velocity;
    scratch.solver_sums[i].spin = body.spin;
  }
}

void find_in_contact(World& world) {
  const Bodies& bodies = world.bodies();
  Scratch& scratch = world.mutable_scratch();
  scratch.in_contact.assign(bodies.size(), 0);
  for (const std::uint32_t k : scratch.layered) {
    const Manifold& m = scratch.manifolds[k];
    if (m.a != kGround && bodies.moves(m.a)) scratch.in_contact[m.a] = 1;
    if (bodies.moves(m.b)) scratch.in_contact[m.b] = 1;
  }
}

double mass_of(const Bodies& bodies, BodyIndex i) {
  return i == kGround || !bodies.moves(i) ? std::numeric_limits<double>::max() : bodies.mass[i];
}

// A point that meets in the middle of the step meets at the speed it will have gained by then: v² = v₀² + 2 a s.
// Without this a bouncing body loses height with every bounce.
void foresee_impact(const World& world, Manifold& m, std::span<ManifoldPoint> points) {
  const Vec3& gravity = world.state().def.gravity;
  const bool a_falls = m.a != kGround && world.bodies().moves(m.a), b_falls = world.bodies().moves(m.b);
  m.acceleration = a_falls == b_falls ? 0 : dot(gravity, m.n) * (b_falls ? 1 : -1);
  for (ManifoldPoint& point : points) {
    if (point.approach >= 0 || point.separation <= 0) continue;
    point.approach = -std::sqrt(std::max(0.0, point.approach * point.approach - 2 * m.acceleration * point.separation));
  }
}

// What stopped an impact in the last step is far more than what carries the weight in this one, and a warm start from
// it would throw the bodies apart.
void forget_impacts(Manifold& m, std::span<ManifoldPoint> points) {
  double before = 0, after = 0;
  for (ManifoldPoint& point : points) {
    before += round_impulse(m, point.impulse);
    if (std::fabs(point.approach) > kRestingSpeed) point.impulse = std::min(point.impulse, point.load);
    after += round_impulse(m, point.impulse);
  }
  if (after == before) return;
  const double kept = after / before;
  m.force1 *= kept;
  m.force2 *= kept;
  m.twist *= kept;
}

// Manifolds of one layer are solved at the same time, so each sees only its share of a body's mass.
void prepare_layer(World& world, std::span<const std::uint32_t> layer, std::vector<std::uint32_t>& uses) {
  Scratch& scratch = world.mutable_scratch();
  for (const std::uint32_t k : layer) {
    const Manifold& m = scratch.manifolds[k];
    if (m.a != kGround) ++uses[m.a];
    ++uses[m.b];
  }
  for (const std::uint32_t k : layer) {
    Manifold& m = scratch.manifolds[k];
    m.split_a = m.a == kGround ? 1 : uses[m.a];
    m.split_b = uses[m.b];
    const double lighter = std::min(mass_of(world.bodies(), m.a), mass_of(world.bodies(), m.b));
    prepare_manifold(m, points_of(scratch, m), solver_body(scratch, m.a), solver_body(scratch, m.b), lighter);
    forget_impacts(m, points_of(scratch, m));
    foresee_impact(world, m, points_of(scratch, m));
  }
  for (const std::uint32_t k : layer) {
    const Manifold& m = scratch.manifolds[k];
    if (m.a != kGround) uses[m.a] = 0;
    uses[m.b] = 0;
  }
}

}  // namespace

Status prepare_manifolds(World& world, double /*dt_s*/) {
  prepare_bodies(world);
  find_in_contact(world);
  const Scratch& scratch = world.scratch();
  std::vector<std::uint32_t> uses(world.bodies().size(), 0);
  for (std::size_t layer = 0; layer + 1 < scratch.layer_start.size(); ++layer) {
    prepare_layer(world, layer_of(scratch, layer), uses);
  }
  batch_contacts(world.mutable_scratch());
  return {};
}

void hash_prepare_manifolds(const World& world, Hasher& hasher) {
  for (const Manifold& m : world.scratch().manifolds) {
    if (m.asleep) continue;
    for (const double value : {m.centre_p, m.centre_q, m.radius, m.relaxation}) hasher.add(value);
    for (const double value : m.friction_inverse) hasher.add(value);
    for (const double value : m.response) hasher.add(value);
    for (const ManifoldPoint& point : points_of(world.scratch(), m)) {
      hasher.add(point.mass);
      hasher.add(point.approach);
    }
  }
}

}  // namespace tumble::sim
