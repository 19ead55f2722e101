#include "src/layered/solve/integrate_positions.h"

#include <algorithm>
#include <string>

#include "src/base/text.h"
#include "src/kernels/kernels_by_width.h"
#include "src/layered/batch/share_sweeps.h"
#include "src/layered/order/solver_body.h"
#include "src/layered/solve/contact_batches.h"
#include "src/layered/solve/fast_bodies.h"
#include "src/layered/solve/solver_hashes.h"
#include "src/layered/solve/sweep_layers.h"
#include "src/math/grid.h"
#include "src/world/body_check.h"
#include "src/world/free_flight.h"
#include "src/world/hash_on_the_way.h"

namespace tumble::sim {
namespace {

constexpr double kStiff = 0.002;  // rad in a substep; below, the inverse inertia is not computed anew
constexpr double kStale = 0.1;    // by what part turning may change the response of a contact; Jacobi passes bear 0.1

// Turns a body as in free flight, which keeps angular momentum and energy. With a constant spin in world axes instead,
// a fast bar would gain both.
void turn(Bodies& bodies, Scratch& scratch, BodyIndex i, double substep_s) {
  SolverBody& body = scratch.solver_bodies[i];
  const Vec3 inertia = bodies.inertia[i], inverse = bodies.inverse_inertia[i];
  const Rotation rotation = rotate_freely(bodies.orientation[i], body.spin, inertia, inverse, substep_s);
  bodies.orientation.set(i, rotation.orientation);
  const double turned_squared = dot(body.spin, body.spin) * (substep_s * substep_s);
  if (turns_evenly(inertia)) return;
  body.spin = rotation.spin;
  if (turned_squared > kStiff * kStiff) {
    set_inertia(body, bodies, scratch, i, axes_of(rotation.orientation));
  }
}

bool in_substep_range(const SolverBody& body) {
  return within(body.velocity, kSubstepSpeedMax) && within(body.spin, kSubstepSpeedMax);
}

// Returns whether place and motion are in range.
bool move_body(Bodies& bodies, Scratch& scratch, BodyIndex i, const Vec3& fall, double substep_s) {
  const Vec3 position = bodies.position[i];
  const SolverBody& body = scratch.solver_bodies[i];
  const bool slow = far_within_limits(position, body.velocity, body.spin);
  if (!slow && !in_substep_range(body)) return false;
  const Vec3 path = (body.velocity - fall) * substep_s;
  const Vec3 moved = plus_zero(position + (slow ? PositionGrid::round(path) : PositionGrid::round_any(path)));
  bodies.position.set(i, moved);
  turn(bodies, scratch, i, substep_s);
  return slow || within(moved, kPositionMax);
}

// Returns whether place and motion are in range. A body that flies moves at the mean of its velocities before and after
// gravity, as in free flight.
bool move(WorldState& state, Scratch& scratch, BodyIndex i, double substep_s) {
  const FastBody* const fast = fast_body(scratch, i);
  if (fast == nullptr) return move_body(state.bodies, scratch, i, Vec3::Zero(), substep_s);
  const double left_s = substep_s - fast->flown_s;
  const Vec3 fall = state.def.gravity * left_s;
  if (!fast->waits)
    return move_body(state.bodies, scratch, i, fast->flying ? Vec3(fall * 0.5) : Vec3(Vec3::Zero()), left_s);
  SolverBody& body = scratch.solver_bodies[i];
  if (!in_substep_range(body)) return false;
  body.velocity -= VelocityGrid::round(fall);
  return true;
}

// Marks the contacts [begin, end) of fast pairs whose bodies have turned so far that they respond otherwise by more
// than kStale: a turn by θ mixes directions by θ². Contacts of other pairs keep the responses of the step's start.
void mark_turned(const Bodies& bodies, Scratch& scratch, std::size_t begin, std::size_t end, double substep_s) {
  const auto turned_far = [&](std::uint32_t row) {
    if (row >= bodies.size() || !bodies.moves(row)) return false;
    const Vec3 &inertia = bodies.inertia[row], spin = scratch.solver_bodies[row].spin;
    const double turned_squared = dot(spin, spin) * (substep_s * substep_s), least = inertia.minCoeff();
    return turned_squared * (inertia.maxCoeff() - least) > kStale * least;
  };
  ContactBatches& all = scratch.fast.batches;
  for (std::size_t k = begin; k < end; ++k) {
    ContactBatch& batch = all.batches[k];
    for (unsigned lane = 0; lane < batch.used; ++lane) {
      const bool turned = turned_far(all.sides[k].a[lane]) || turned_far(all.sides[k].b[lane]);
      if (turned) batch.turns = static_cast<std::uint8_t>(batch.turns | 1U << lane);
    }
  }
}

// "body 7 (0.002 kg)"
std::string named(const Bodies& bodies, BodyIndex i) {
  return "body " + std::to_string(bodies.id[i]) + " (" + significant(bodies.mass[i], 3) + " kg)";
}

// The heaviest body that touches body i, the one of the lowest id if several are; kGround if none does.
BodyIndex heaviest_touching(const Bodies& bodies, const Scratch& scratch, BodyIndex i) {
  BodyIndex heaviest = kGround;
  const auto look_at = [&](const Manifold& m) {
    if (m.a == kGround || (m.a != i && m.b != i)) return;
    const BodyIndex other = m.a == i ? m.b : m.a;
    const bool heavier = heaviest == kGround || bodies.mass[other] > bodies.mass[heaviest];
    if (heavier || (bodies.mass[other] == bodies.mass[heaviest] && bodies.id[other] < bodies.id[heaviest])) {
      heaviest = other;
    }
  };
  for (const std::uint32_t k : scratch.layered) look_at(scratch.manifolds[k]);
  if (!scratch.fast.none()) std::ranges::for_each(scratch.fast.found.manifolds, look_at);
  return heaviest;
}

// Errors: the first body whose motion left the limits.
Status check_moved(const Bodies& bodies, const Scratch& scratch) {
  const auto found = std::find(scratch.in_contact.begin(), scratch.in_contact.end(), kBeyond);
  if (found == scratch.in_contact.end()) [[likely]]
    return {};
  const auto i = static_cast<BodyIndex>(found - scratch.in_contact.begin());
  const SolverBody& body = scratch.solver_bodies[i];
  const BodyIndex heaviest = heaviest_touching(bodies, scratch, i);
  const std::string both = named(bodies, i) + " on " + (heaviest == kGround ? "the ground" : named(bodies, heaviest));
  if (!within(bodies.position[i], kPositionMax)) return beyond(both, "position", bodies.position[i], kPositionMax, "m");
  if (!within(body.spin, kSubstepSpeedMax)) return beyond(both, "spin", body.spin, kSubstepSpeedMax, "rad/s");
  return beyond(both, "velocity", body.velocity, kSubstepSpeedMax, "m/s");
}

// Adds where the bodies in contact have moved, and what turning has changed of their rows: the spin and the inertia of
// a body with different moments of inertia, and the velocity of a body of a fast pair.
void add_moved(const Bodies& bodies, const Scratch& scratch, std::size_t begin, std::size_t end,
               GatheredNumbers& numbers) {
  for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) {
    if (scratch.in_contact[i] == 0) continue;
    numbers.add(bodies.position[i]);
    numbers.add(bodies.orientation[i]);
    if (!turns_evenly(bodies.inertia[i]) || fast_body(scratch, i) != nullptr)
      numbers.add(doubles_of(scratch.solver_bodies, i, i + 1));
  }
}

}  // namespace

Status integrate_positions(WorldState& state, Scratch& scratch, double substep_s) {
  Hasher* const hasher = take_hasher(scratch);
  const Bodies& bodies = state.bodies;
  if (!scratch.fast.none()) find_flying(bodies, scratch, substep_s);
  const auto move_bodies = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (scratch.in_contact[i] == 0) continue;
      if (!move(state, scratch, static_cast<BodyIndex>(i), substep_s)) scratch.in_contact[i] = kBeyond;
    }
  };
  GatheredNumbers numbers(hasher);
  for_hashed_bodies(hasher, scratch, bodies.size(), kBodiesABlock, move_bodies,
                    [&](std::size_t begin, std::size_t end) { add_moved(bodies, scratch, begin, end, numbers); });
  if (Status ok = check_moved(bodies, scratch); !ok.ok()) return ok;
  // A bar is thousands of times as easy to turn about its length as across it. After a turn by a degree the right
  // impulse is several times smaller, and sweeps with the old response would diverge. So it is with light bodies whose
  // levers turn far, and with any body of a fast pair that turns by some tenths of a radian.
  renew_copies(scratch);
  ContactWork work = all_contacts(scratch, substep_s);
  work.turn_s = substep_s;
  const auto move_points = [&](std::size_t begin, std::size_t end) {
    kernels(scratch.lanes).contacts.move_on(part_of(work, begin, end));
    kernels(scratch.lanes).contacts.renew(part_of(work, begin, end));
  };
  for_hashed_batches(hasher, scratch, move_points, [&](std::size_t begin, std::size_t end) {
    add_moved_contacts(scratch.contact_batches, begin, end, numbers);
  });
  numbers.pass_on();
  if (scratch.fast.none()) return {};
  for_fast_batches(scratch, substep_s, [&](const ContactWork& part, std::size_t begin, std::size_t end) {
    mark_turned(bodies, scratch, begin, end, substep_s);
    kernels(scratch.lanes).contacts.move_on(part);
    kernels(scratch.lanes).contacts.renew(part);
  });
  if (hasher != nullptr) add_fast_batches(scratch, *hasher);
  return {};
}

void hash_integrate_positions(const WorldState& state, const Scratch& scratch, Hasher& hasher) {
  const ContactBatches& all = scratch.contact_batches;
  GatheredNumbers numbers(&hasher);
  add_moved(state.bodies, scratch, 0, state.bodies.size(), numbers);
  for (std::size_t k = 0; k < all.batches.size(); k += kBatchesABlock) {
    add_moved_contacts(all, k, std::min(k + kBatchesABlock, all.batches.size()), numbers);
  }
  numbers.pass_on();
  if (!scratch.fast.none()) add_fast_batches(scratch, hasher);
}

}  // namespace tumble::sim
