#include "src/solve/sweep_layers.h"

#include <algorithm>

#include "src/math/grid.h"
#include "src/solve/solver_body.h"

namespace tumble::sim {
namespace {

constexpr int kLevelsPerSweep = 5;  // measured: columns of 8 that sway after a fall come to rest with two, not with one
constexpr int kSweepsMax = 10;

void add_side(Scratch& scratch, BodyIndex i, const Vec3& force, const Vec3& torque) {
  if (i == kGround) return;
  const SolverBody& body = scratch.solver_bodies[i];
  if (body.inverse_mass == 0) return;
  scratch.next_velocity.add(i, VelocityGrid::round(Vec3(force * body.inverse_mass)));
  scratch.next_spin.add(i, VelocityGrid::round(spin_of(body, torque)));
}

void commit(Scratch& scratch, BodyIndex i) {
  if (i == kGround) return;
  scratch.solver_bodies[i].velocity = scratch.next_velocity[i];
  scratch.solver_bodies[i].spin = scratch.next_spin[i];
}

void solve_layer(Scratch& scratch, std::span<const std::uint32_t> layer, Sweep sweep, double substep_s) {
  for (const std::uint32_t k : layer) {
    Manifold& m = scratch.manifolds[k];
    const Wrench wrench = solve_manifold(sweep, m, points_of(scratch, m), solver_body(scratch, m.a),
                                         solver_body(scratch, m.b), substep_s);
    add_wrench(scratch, m, wrench);
  }
  for (const std::uint32_t k : layer) {
    commit(scratch, scratch.manifolds[k].a);
    commit(scratch, scratch.manifolds[k].b);
  }
}

}  // namespace

void add_wrench(Scratch& scratch, const Manifold& m, const Wrench& wrench) {
  add_side(scratch, m.b, wrench.force, wrench.torque);
  add_side(scratch, m.a, -wrench.force, -reaction_torque(m, wrench));
}

void sweep_layers(World& world, Sweep sweep, Direction direction, double substep_s) {
  Scratch& scratch = world.mutable_scratch();
  const std::size_t layers = scratch.layer_start.size() - 1;
  for (std::size_t k = 0; k < layers; ++k) {
    const std::size_t layer = direction == Direction::kUp ? k : layers - 1 - k;
    solve_layer(scratch, layer_of(scratch, layer), sweep, substep_s);
  }
}

int sweep_count(const Scratch& scratch) {
  const int levels = static_cast<int>(scratch.layer_start.size() - 2) / 2;
  return std::min(kSweepsMax, 1 + levels / kLevelsPerSweep);
}

void hash_solution(const World& world, Hasher& hasher) {
  const Scratch& scratch = world.scratch();
  for (const auto* column : {&scratch.next_velocity.x, &scratch.next_velocity.y, &scratch.next_velocity.z,
                             &scratch.next_spin.x, &scratch.next_spin.y, &scratch.next_spin.z}) {
    hasher.add(std::span<const double>(*column));
  }
  for (const Manifold& m : scratch.manifolds) {
    for (const double value : {m.force1, m.force2, m.twist}) hasher.add(value);
    for (const ManifoldPoint& point : points_of(scratch, m)) hasher.add(point.impulse);
  }
}

}  // namespace tumble::sim
