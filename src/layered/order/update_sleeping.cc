#include "src/layered/order/update_sleeping.h"

#include <algorithm>
#include <cmath>

#include "src/layered/islands/later_numbers.h"
#include "src/world/body_check.h"
#include "src/world/for_bodies.h"
#include "src/world/islands.h"

namespace tumble::sim {
namespace {

// Of gravity. What gains speed faster is not at rest, however slow it is. A slope gives that much at an angle of
// 1e-5 rad; a body at rest gains and loses a thousandth of it, by rounding.
constexpr double kSpeedingUp = 1e-5;

// m/s, of a move that parts an overlap; of a deep one, where slower moves count too. What parts more slowly is jammed.
constexpr double kParting = 0.01, kPartingDeep = 1e-4;
constexpr double kDeep = 0.04;  // of the smallest half extent

constexpr double kTipping = 1e-4;  // of gravity; rubble that creeps sleeps

// m/s, of a body that has that energy per kilogram and does not turn.
double speed_of(double energy_per_kg) { return std::sqrt(2 * energy_per_kg); }

// J/kg, of the motion that parts a body from others; as if all of its mass turned at the distance of a corner, which is
// a bound.
double parting(const Scratch& scratch, BodyIndex i) {
  if (!scratch.overlaps_part) return 0;
  const Vec3 velocity = parting_velocity(scratch)[i], spin = parting_spin(scratch)[i];
  const Vec3& half = scratch.frames[i].half_extent;
  return 0.5 * (dot(velocity, velocity) + dot(spin, spin) * dot(half, half));
}

// Calls visit(manifold) for all manifolds that touch, by several workers at a time.
template <class Visit>
void for_touching(const Scratch& scratch, Visit visit) {
  for_manifolds(scratch, scratch.manifolds.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (touches(scratch, scratch.manifolds[k])) visit(scratch.manifolds[k]);
    }
  });
}

// What touches, and the least time of rest of each body and of those that it touches. So a body that does not rest
// starts the times of all around it anew, one contact further with each step: what falls off a plank leaves no plank
// behind that has rested for long.
void look_around(const Bodies& bodies, Scratch& scratch) {
  SleepScratch& sleeping = scratch.sleeping;
  fill_bodies(scratch, bodies.size(), sleeping.touching, std::uint8_t{0});
  std::vector<double>& least = least_rests(scratch);
  least.resize(bodies.size());
  for_bodies(scratch, bodies.size(), [&](std::size_t begin, std::size_t end) {
    std::copy(bodies.low_energy_time.data() + begin, bodies.low_energy_time.data() + end, least.data() + begin);
  });
  for_touching(scratch, [&](const Manifold& m) {
    mark(sleeping.touching[m.b]);
    if (m.a == kGround) return;
    mark(sleeping.touching[m.a]);
    if (!bodies.moves(m.a) || !bodies.moves(m.b)) return;
    shared::lower(least[m.a], bodies.low_energy_time[m.b]);
    shared::lower(least[m.b], bodies.low_energy_time[m.a]);
  });
}

// Advances the timers. Returns whether a body has been slow for long enough.
bool advance_timers(WorldState& state, Scratch& scratch, double dt_s) {
  const WorldDef& def = state.def;
  Bodies& bodies = state.bodies;
  std::uint8_t any = 0;
  for_bodies(scratch, bodies.size(), [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) {
      if (!bodies.moves(i)) continue;
      const bool low = scratch.sleeping.touching[i] != 0 && energy_per_mass(bodies, i) < def.freeze_energy &&
                       parting(scratch, i) < def.freeze_energy;
      bodies.low_energy_time[i] = low ? least_rests(scratch)[i] + dt_s : 0;
      if (bodies.low_energy_time[i] >= def.freeze_time) mark(any);
    }
  });
  return any != 0;
}

void put_to_sleep(Bodies& bodies, BodyIndex i) {
  bodies.frozen[i] = 1;
  bodies.low_energy_time[i] = 0;
  bodies.velocity.set(i, Vec3::Zero());
  bodies.spin.set(i, Vec3::Zero());
}

bool rests(const Bodies& bodies, BodyIndex i) { return i == kGround || !bodies.moves(i); }

// Marks the islands that touch the ground, a static or a sleeping body: nothing else can hold a slow island where it
// is. Also those of several bodies.
void mark_held(const Bodies& bodies, Scratch& scratch, Islands& islands) {
  std::vector<std::uint8_t>&held = scratch.sleeping.held, &together = scratch.sleeping.together;
  fill_bodies(scratch, bodies.size(), held, std::uint8_t{0});
  fill_bodies(scratch, bodies.size(), together, std::uint8_t{0});
  for_touching(scratch, [&](const Manifold& m) {
    if (!rests(bodies, m.a) && !rests(bodies, m.b)) mark(together[islands.of(m.b)]);
    if (rests(bodies, m.a) && !rests(bodies, m.b)) mark(held[islands.of(m.b)]);
    if (rests(bodies, m.b) && !rests(bodies, m.a)) mark(held[islands.of(m.a)]);
  });
}

// Calls visit(body) for all bodies that move, by several workers at a time.
template <class Visit>
void for_moving(const Bodies& bodies, const Scratch& scratch, Visit visit) {
  for_bodies(scratch, bodies.size(), [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) {
      if (bodies.moves(i)) visit(i);
    }
  });
}

// Of each island the largest energy per kilogram of a body, before the step and now. A largest one depends on no order,
// as a sum of energies would.
void find_liveliest(const Bodies& bodies, Scratch& scratch, Islands& islands) {
  std::vector<double>&before = liveliest_before(scratch), &after = liveliest_after(scratch);
  fill_bodies(scratch, bodies.size(), before, 0.0);
  fill_bodies(scratch, bodies.size(), after, 0.0);
  for_moving(bodies, scratch, [&](BodyIndex i) {
    const BodyIndex island = islands.of(i);
    shared::raise(before[island], scratch.sleeping.energy_before[i]);
    shared::raise(after[island], energy_per_mass(bodies, i));
  });
}

// Whether a force moves an island. A body alone that loses speed must come to rest first, since what brakes it may turn
// it back; a heap or a tower sways for seconds, so it may sleep where its sway goes down.
bool is_pushed(Scratch& scratch, BodyIndex island, double gain) {
  const double gained = speed_of(liveliest_after(scratch)[island]) - speed_of(liveliest_before(scratch)[island]);
  return (scratch.sleeping.together[island] != 0 ? gained : std::fabs(gained)) > gain;
}

// Whether a body is moved out of what it overlaps by more than twice of what solving leaves, or by much.
bool parts(const Bodies& bodies, const Scratch& scratch, const Manifold& m) {
  const auto speed = [&](BodyIndex i) { return rests(bodies, i) ? 0.0 : speed_of(parting(scratch, i)); };
  const double fastest = std::max(speed(m.a), speed(m.b));
  if (fastest <= kPartingDeep) return false;
  const BoxFrame& b = scratch.frames[m.b];
  const double smallest = smallest_half_extent(m.a == kGround ? b : scratch.frames[m.a], b);
  const double least = fastest > kParting ? 2 * std::min(kSlop, kSlopOfHalfExtent * smallest) : kDeep * smallest;
  return std::ranges::any_of(points_of(scratch, m), [&](const ManifoldPoint& p) { return p.separation < -least; });
}

// Whether a body tips: its weight and what it bears lie outside of what supports it (carry_weights), and it moves. A
// light body under a heavy one tips at an even speed at first, so the gain of a step does not show it. What leans or is
// wedged lies so too, and may creep; the longer it has, the faster it may, since what tips is fast after some seconds.
bool tips(const WorldState& state, const Scratch& scratch, BodyIndex i) {
  if (scratch.weights.held[i] != 0) return false;
  const double rest = state.bodies.low_energy_time[i];
  const double gained = kTipping * length(state.def.gravity) * rest;  // m/s
  return speed_of(energy_per_mass(state.bodies, i)) * state.def.freeze_time > gained * rest;
}

// Marks the islands that would not stay where they are.
void mark_restless(const WorldState& state, Scratch& scratch, Islands& islands, double dt_s) {
  const Bodies& bodies = state.bodies;
  std::vector<std::uint8_t>& restless = scratch.sleeping.restless;
  fill_bodies(scratch, bodies.size(), restless, std::uint8_t{0});
  find_liveliest(bodies, scratch, islands);
  const double gain = kSpeedingUp * length(state.def.gravity) * dt_s;
  for_moving(bodies, scratch, [&](BodyIndex i) {
    const BodyIndex island = islands.of(i);
    const bool rested = bodies.low_energy_time[i] >= state.def.freeze_time;
    if (!rested || is_pushed(scratch, island, gain) || tips(state, scratch, i)) mark(restless[island]);
  });
  for_touching(scratch, [&](const Manifold& m) {
    if (!parts(bodies, scratch, m)) return;
    for (const BodyIndex i : {m.a, m.b}) {
      if (!rests(bodies, i)) mark(restless[islands.of(i)]);
    }
  });
}

// Puts the islands to sleep that are held and of which nothing would move on.
void freeze_islands(WorldState& state, Scratch& scratch, double dt_s) {
  Bodies& bodies = state.bodies;
  Islands islands(scratch.island_links, bodies.size(), scratch.workers);
  for_touching(scratch, [&](const Manifold& m) {
    if (m.a != kGround && bodies.is_static[m.a] == 0 && bodies.is_static[m.b] == 0) islands.join(m.a, m.b);
  });
  mark_held(bodies, scratch, islands);
  mark_restless(state, scratch, islands, dt_s);
  const std::vector<std::uint8_t>& restless = scratch.sleeping.restless;
  for_moving(bodies, scratch, [&](BodyIndex i) {
    const BodyIndex island = islands.of(i);
    if (restless[island] == 0 && scratch.sleeping.held[island] != 0) put_to_sleep(bodies, i);
  });
}

}  // namespace

void note_energies(const WorldState& state, Scratch& scratch, double dt_s) {
  const Bodies& bodies = state.bodies;
  std::vector<double>& energy = scratch.sleeping.energy_before;
  fill_bodies(scratch, bodies.size(), energy, 0.0);
  if (!state.def.freezing) return;
  const double from = state.def.freeze_time - 2 * dt_s;
  for_bodies(scratch, bodies.size(), [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) {
      if (bodies.low_energy_time[i] >= from && bodies.moves(i)) energy[i] = energy_per_mass(bodies, i);
    }
  });
}

Status update_sleeping(WorldState& state, Scratch& scratch, double dt_s) {
  look_around(state.bodies, scratch);
  const bool slow_for_long = advance_timers(state, scratch, dt_s);
  // Without gravity nothing holds a body: it drifts on.
  if (slow_for_long && state.def.freezing && state.def.gravity != Vec3::Zero()) freeze_islands(state, scratch, dt_s);
  return {};
}

void hash_update_sleeping(const WorldState& state, const Scratch& /*scratch*/, Hasher& hasher) {
  const Bodies& bodies = state.bodies;
  hasher.add(std::span<const std::uint8_t>(bodies.frozen));
  hasher.add(std::span<const double>(bodies.low_energy_time));
  hash_frozen_velocities(state.bodies, hasher);
}

}  // namespace tumble::sim
