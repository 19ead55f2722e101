#include "src/layered/solve/part_overlaps.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/kernels/kernels_by_width.h"
#include "src/layered/batch/share_sweeps.h"
#include "src/layered/islands/sweep_counts.h"
#include "src/layered/solve/contact_batches.h"
#include "src/layered/solve/solver_hashes.h"
#include "src/layered/solve/sweep_layers.h"
#include "src/math/grid.h"
#include "src/math/half_turn.h"
#include "src/math/lift_cost.h"
#include "src/world/for_bodies.h"
#include "src/world/hash_on_the_way.h"

namespace tumble::sim {
namespace {

constexpr double kPart = 1.0 / 3;  // of an overlap, removed in a step

// The overlaps are solved in the columns of the step's own impulses and motions, which wait meanwhile: motions in those
// of the parting speeds, impulses as begin_parting says.
void exchange_motions(Scratch& scratch, bool before) {
  Vec3Column &velocity = parting_velocity(scratch), &spin = parting_spin(scratch);
  std::vector<SolverBody>& bodies = scratch.solver_bodies;
  const Vec3 none = Vec3::Zero();
  const auto exchange = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      velocity.set(i, std::exchange(bodies[i].velocity, before ? none : velocity[i]));
      spin.set(i, std::exchange(bodies[i].spin, before ? none : spin[i]));
    }
  };
  const std::size_t n = scratch.in_contact.size();
  for_bodies(scratch, n, exchange);
  for_ranges(scratch.workers, bodies.size() - n, kBodiesAPart,  // the ground's row, and those of copies
             [&](std::size_t begin, std::size_t end) { exchange(n + begin, n + end); });
}

void begin(Scratch& scratch, const ContactWork& work) {
  parting_velocity(scratch).resize(scratch.solver_bodies.size());
  parting_spin(scratch).resize(scratch.solver_bodies.size());
  for_shared_batches(scratch, [&](std::size_t begin, std::size_t end) {
    kernels(scratch.lanes).contacts.begin_parting(part_of(work, begin, end));
  });
  exchange_motions(scratch, true);
}

void end(Scratch& scratch) {
  ContactBatches& all = scratch.contact_batches;
  for_shared_batches(scratch, [&](std::size_t begin, std::size_t end) {
    const ContactBatch& last = all.batches[end - 1];
    for (std::size_t k = all.batches[begin].first; k < last.first + last.count; ++k) {
      all.points[k].impulse = std::exchange(all.points[k].peak, {});
    }
  });
  exchange_motions(scratch, false);
}

void solve(const WorldState& state, Scratch& scratch, ContactWork work, double deepest, Hasher* hasher) {
  work.push_part = kPart;
  const int more = parting_sweeps(deepest);
  if (more > 1) count_parting_sweeps(state, scratch);
  begin(scratch, work);
  sweep_overlaps(scratch, work, more);
  const auto move_on = [&](std::size_t begin, std::size_t end) {
    kernels(scratch.lanes).contacts.move_on(part_of(work, begin, end));
  };
  GatheredNumbers numbers(hasher);
  for_hashed_batches(hasher, scratch, move_on, [&](std::size_t begin, std::size_t end) {
    add_separations(scratch.contact_batches, begin, end, numbers);
  });
  end(scratch);
}

// Takes from the motion of a body that was moved along `path` what a lift adds to its energy: from the speed along
// gravity, and what that lacks from the whole motion.
void pay(const WorldState& state, SolverBody& body, BodyIndex i, const Vec3& path) {
  const Vec3& gravity = state.def.gravity;
  if (dot(gravity, path) >= 0) return;
  const LiftCost cost = pay_for_lift(body.velocity, path, gravity, gravity / -length(gravity));
  const double left = energy_per_mass(state.bodies, i) - cost.removed;  // J/kg
  const double part = cost.unpaid < left ? std::sqrt(1 - cost.unpaid / left) : 0;
  body.velocity = VelocityGrid::round_any(Vec3(cost.velocity * part));
  body.spin = VelocityGrid::round_any(Vec3(body.spin * part));
}

void move_apart(WorldState& state, Scratch& scratch, BodyIndex i, double dt_s) {
  Bodies& bodies = state.bodies;
  SolverBody& body = scratch.solver_bodies[i];
  const Vec3 velocity = parting_velocity(scratch)[i], spin = parting_spin(scratch)[i];
  if (velocity != Vec3::Zero()) {
    const Vec3 path = PositionGrid::round_any(Vec3(velocity * dt_s));
    bodies.position.set(i, plus_zero(bodies.position[i] + path));
    pay(state, body, i, path);
  }
  if (spin != Vec3::Zero()) {
    bodies.orientation.set(i, turned(bodies.orientation[i], spin * (0.5 * dt_s)));
  }
}

// Adds the bodies that part: their rows, where they part to, and what that takes from their motion.
void add_parting(const WorldState& state, const Scratch& scratch, std::size_t begin, std::size_t end,
                 GatheredNumbers& numbers) {
  for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) {
    const Vec3 velocity = parting_velocity(scratch)[i], spin = parting_spin(scratch)[i];
    if (velocity == Vec3::Zero() && spin == Vec3::Zero()) continue;
    *numbers.next(1) = static_cast<double>(i);
    numbers.add(state.bodies.position[i]);
    numbers.add(state.bodies.orientation[i]);
    const SolverBody& body = scratch.solver_bodies[i];
    for (const Vec3* const v : {&velocity, &spin, &body.velocity, &body.spin}) numbers.add(*v);
  }
}

}  // namespace

Status part_overlaps(WorldState& state, Scratch& scratch, double dt_s) {
  Hasher* const hasher = take_hasher(scratch);
  const double deepest = find_overlaps(scratch, all_contacts(scratch, dt_s));
  scratch.overlaps_part = deepest > 0;
  // So that the first overlap of a warm world allocates nothing.
  for (Vec3Column* const column : {&parting_velocity(scratch), &parting_spin(scratch)}) {
    for (std::vector<double>* const of : {&column->x, &column->y, &column->z}) {
      of->reserve(scratch.solver_bodies.capacity());
    }
  }
  if (!scratch.overlaps_part) return {};
  solve(state, scratch, all_contacts(scratch, dt_s), deepest, hasher);
  const auto move_bodies = [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) {
      move_apart(state, scratch, i, dt_s);
    }
  };
  GatheredNumbers numbers(hasher);
  for_hashed_bodies(hasher, scratch, state.bodies.size(), kBodiesABlock, move_bodies,
                    [&](std::size_t begin, std::size_t end) { add_parting(state, scratch, begin, end, numbers); });
  return {};
}

void hash_part_overlaps(const WorldState& state, const Scratch& scratch, Hasher& hasher) {
  if (!scratch.overlaps_part) return;
  GatheredNumbers numbers(&hasher);
  add_separations(scratch.contact_batches, 0, scratch.contact_batches.batches.size(), numbers);
  add_parting(state, scratch, 0, state.bodies.size(), numbers);
}

}  // namespace tumble::sim
