#include "src/thesis/compute_impulses.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "src/kernels/kernels_by_width.h"
#include "src/math/grid.h"
#include "src/thesis/collision_impulse.h"
#include "src/thesis/ground/ground_collisions.h"
#include "src/thesis/ground/ground_points.h"
#include "src/thesis/split_mass.h"
#include "src/world/body_check.h"
#include "src/world/hash_on_the_way.h"

namespace tumble::sim {
namespace {

// How one part of a body answers impulses.
Response part_response(const WorldState& state, const Scratch& scratch, BodyIndex i) {
  const double parts = scratch.split.parts[i];
  return {parts * state.bodies.inverse_mass[i], state.bodies.inverse_inertia[i] * parts};
}

// One part of a body, as a collision meets it, but for r. gravity_gain: m/s in this substep, of a body that moves.
void take_body(const WorldState& state, const Scratch& scratch, BodyIndex i, const Vec3& gravity_gain,
               ContactBody& body) {
  const Bodies& bodies = state.bodies;
  static_cast<Response&>(body) = part_response(state, scratch, i);
  body.velocity = bodies.velocity[i];
  body.spin = bodies.spin[i];
  body.axes = scratch.frames[i].axes;
  body.gained = bodies.moves(i) ? gravity_gain : Vec3(Vec3::Zero());
}

// The corners that touch in contact k, from the collision point.
std::span<const Vec3> patch_of(const Contacts& contacts, std::size_t k) {
  const std::uint32_t begin = k == 0 ? 0 : contacts.patch_end[k - 1];
  return std::span(contacts.patch).subspan(begin, contacts.patch_end[k] - begin);
}

// A body of a collision. row: of its gain and energy in SplitScratch; turn: about its centre; sign: +1 for b, −1 for
// a, since the impulse on a is the negative of that on b, to the bit.
struct Side {
  BodyIndex body;
  std::size_t row;
  Vec3 turn;
  double sign;
  std::uint8_t hit;
};

// How a collision hits its bodies, for Scratch::hit.
std::uint8_t hit_of(const SplitScratch& split, std::size_t k, bool resting) {
  const bool fully = split.materials[k].restitution == 1;
  return static_cast<std::uint8_t>((resting ? 0 : kHit) + (fully ? kBouncesFully : 0));
}

// Finds the outcome of a collision for one body. At rest friction acts evenly throughout the substep, as gravity does:
// half of the speed that friction takes, times the substep, is taken from the way as well.
void find_gain(const Bodies& bodies, const BoxFrame& frame, const Side& side, const Collision& collision, double dt_s,
               const Vec3& turning, Gain& gain) {
  const double yield = side.sign * bodies.inverse_mass[side.body];
  gain.velocity = VelocityGrid::round(Vec3(collision.impulse * yield));
  gain.spin = VelocityGrid::round(to_world(frame.axes, Vec3(turning * side.sign)));
  gain.largest = std::max(gain.velocity.cwiseAbs().maxCoeff(), gain.spin.cwiseAbs().maxCoeff());
  gain.way_back = Vec3::Zero();
  if (!collision.resting) return;
  const Vec3 slowed = VelocityGrid::round(Vec3(collision.friction * yield));
  gain.way_back = PositionGrid::round(Vec3(slowed * (0.5 * dt_s)));
}

// Adds an outcome to the sum of its body. Returns whether outcome and sum are small enough; beyond() tells of those
// that are not.
bool add_gain(Scratch& scratch, const Side& side, bool resting) {
  SplitScratch& split = scratch.split;
  split.changed[side.body] = 1;
  scratch.hit[side.body] |= side.hit;
  const Gain& gain = split.gains[side.row];
  Gain& sum = scratch.gains[side.body];
  sum.velocity += gain.velocity;
  sum.spin += gain.spin;
  if (resting) sum.way_back += gain.way_back;
  sum.largest += gain.largest;
  return magnitudes(gain.velocity) + magnitudes(gain.spin) <= kSpeedMax && sum.largest <= kGainTotalMax;
}

// Finds the outcome of a collision for one body, its energy if the body has several contacts (split_mass.h), and adds
// it to the sum of the body.
bool add_outcome(const Bodies& bodies, Scratch& scratch, const Side& side, const Collision& collision, double dt_s) {
  const BodyIndex i = side.body;
  SplitScratch& split = scratch.split;
  Gain& gain = split.gains[side.row];
  double& energy = split.energy[side.row];
  energy = 0;
  if (bodies.inverse_mass[i] == 0) {
    split.changed[i] = 1;
    scratch.hit[i] |= side.hit;
    gain = {};
    return true;
  }
  const Vec3 turning = side.turn.cwiseProduct(bodies.inverse_inertia[i]);
  find_gain(bodies, scratch.frames[i], side, collision, dt_s, turning, gain);
  if (split.contacts[i] > 1) {
    energy = bodies.mass[i] * dot(gain.velocity, gain.velocity) + dot(side.turn, turning);
  }
  return add_gain(scratch, side, collision.resting);
}

// The error of a gain or a sum that may be too large, if it is.
Status check_outcome(const Bodies& bodies, const Scratch& scratch, const Side& side) {
  const Gain& gain = scratch.split.gains[side.row];
  if (Status ok = check_gain(bodies, side.body, gain.velocity, gain.spin); !ok.ok()) return ok;
  return check_gains(bodies, side.body, scratch.gains[side.body].largest);
}

// Sums of grid doubles are exact: a gain taken back leaves what the other gains add up to.
void take_back(Gain& sum, const Gain& gain) {
  sum.velocity -= gain.velocity;
  sum.spin -= gain.spin;
  sum.way_back -= gain.way_back;
  sum.largest -= gain.largest;
}

void take_back_gains(Scratch& scratch) {
  const Contacts& contacts = scratch.contacts;
  const SplitScratch& split = scratch.split;
  for (const std::uint32_t k : split.again) {
    take_back(scratch.gains[contacts.a[k]], split.gains[2 * k]);
    if (contacts.b[k] != kGround) take_back(scratch.gains[contacts.b[k]], split.gains[2 * k + 1]);
  }
}

// The collisions of one round. Contacts of one body a follow one another, so on_a_ is mostly the last one's.
class Collisions {
 public:
  Collisions(const WorldState& state, Scratch& scratch, double dt_s)
      : state_(state), scratch_(scratch), gravity_gain_(VelocityGrid::round(Vec3(state.def.gravity * dt_s))) {}

  // From the velocities before all collisions, with the whole mass of each body.
  Collision first(std::size_t k) {
    meet(k);
    const SplitScratch& split = scratch_.split;
    return collide(on_a_, on_b_of(k), scratch_.contacts.normal[k], split.materials[k], split.encounters[k],
                   patch_of(scratch_.contacts, k));
  }

  // With as many parts of the bodies as there are now.
  Collision again(std::size_t k) {
    const Contacts& contacts = scratch_.contacts;
    const BodyIndex a = contacts.a[k], b = contacts.b[k];
    const Vec3 normal = contacts.normal[k];
    if (scratch_.split.met[k] == 0) meet(k);
    const PairMaterial& material = scratch_.split.materials[k];
    const Encounter& met = scratch_.split.encounters[k];
    if (met.approach >= 0) return {};
    if (!met.shared) {
      const Response on_b = b == kGround ? Response{} : part_response(state_, scratch_, b);
      return collide_at_point(part_response(state_, scratch_, a), on_b, normal, material, met);
    }
    take_bodies(k);
    return collide(on_a_, on_b_of(k), normal, material, met, patch_of(contacts, k));
  }

 private:
  // Finds how the bodies of a contact meet, which no later round changes.
  void meet(std::size_t k) {
    const Contacts& contacts = scratch_.contacts;
    SplitScratch& split = scratch_.split;
    split.met[k] = 1;
    split.materials[k] = pair_material(state_, contacts.a[k], contacts.b[k]);
    take_bodies(k);
    find_encounter(on_a_, on_b_of(k), contacts.normal[k], split.materials[k], patch_of(contacts, k).size(),
                   split.encounters[k]);
  }

  [[nodiscard]] const ContactBody& on_b_of(std::size_t k) const {
    return scratch_.contacts.b[k] == kGround ? on_ground_ : on_b_;
  }

  void take_bodies(std::size_t k) {
    const Contacts& contacts = scratch_.contacts;
    const BodyIndex a = contacts.a[k], b = contacts.b[k];
    if (a != last_) take_body(state_, scratch_, a, gravity_gain_, on_a_);
    last_ = a;
    on_a_.r = contacts.r_a[k];
    if (b == kGround) return;
    take_body(state_, scratch_, b, gravity_gain_, on_b_);
    on_b_.r = contacts.r_b[k];
  }

  const WorldState& state_;
  Scratch& scratch_;
  Vec3 gravity_gain_;
  BodyIndex last_ = kGround;  // the body that on_a_ is of
  ContactBody on_a_, on_b_;
  const ContactBody on_ground_;
};

// Computes the collisions with the ground in lanes and adds their gains: add_collisions of the first round.
Status collide_with_ground(const WorldState& state, Scratch& scratch, std::size_t begin, double dt_s) {
  const Contacts& contacts = scratch.contacts;
  SplitScratch& split = scratch.split;
  kernels(scratch.lanes).ground.collide(ground_collisions(state, scratch, dt_s), begin, contacts.size());
  for (std::size_t k = begin; k < contacts.size(); ++k) {
    const BodyIndex a = contacts.a[k];
    if (split.contacts[a] == 1) split.energy[2 * k] = 0;
    const bool resting = split.resting[k] != 0;
    const Side side = {a, 2 * k, Vec3::Zero(), -1, hit_of(split, k, resting)};
    if (add_gain(scratch, side, resting)) [[likely]]
      continue;
    if (Status ok = check_outcome(state.bodies, scratch, side); !ok.ok()) return ok;
  }
  return {};
}

// Computes the collisions of this round and adds their gains.
Status add_collisions(const WorldState& state, Scratch& scratch, int round, double dt_s) {
  Contacts& contacts = scratch.contacts;
  SplitScratch& split = scratch.split;
  const Bodies& bodies = state.bodies;
  Collisions collisions(state, scratch, dt_s);
  const bool in_lanes = round == 0 && kernels(scratch.lanes).ground.collide != nullptr;
  const std::size_t singly = in_lanes ? ground_begin(contacts) : split.again.size();
  for (const std::uint32_t k : std::span(split.again).first(singly)) {
    const BodyIndex a = contacts.a[k], b = contacts.b[k];
    const Collision collision = round == 0 ? collisions.first(k) : collisions.again(k);
    contacts.impulse.set(k, collision.impulse);
    const std::uint8_t hit = hit_of(split, k, collision.resting);
    const Side side_a = {a, 2 * k, collision.turn_a, -1, hit};
    if (!add_outcome(bodies, scratch, side_a, collision, dt_s)) [[unlikely]] {
      if (Status ok = check_outcome(bodies, scratch, side_a); !ok.ok()) return ok;
    }
    if (b == kGround) continue;
    const Side side_b = {b, 2 * k + 1, collision.turn_b, 1, hit};
    if (!add_outcome(bodies, scratch, side_b, collision, dt_s)) [[unlikely]] {
      if (Status ok = check_outcome(bodies, scratch, side_b); !ok.ok()) return ok;
    }
  }
  return in_lanes ? collide_with_ground(state, scratch, singly, dt_s) : Status{};
}

void reset_gains(Scratch& scratch, std::size_t bodies) {
  const Contacts& contacts = scratch.contacts;
  scratch.gains.resize(bodies);
  scratch.hit.assign(bodies, 0);
  scratch.touched.assign(bodies, 0);
  const auto touch = [&](BodyIndex i) {
    scratch.touched[i] = 1;
    scratch.gains[i] = {};
  };
  for (const BodyIndex i : contacts.a) touch(i);
  for (const BodyIndex i : contacts.b) {
    if (i != kGround) touch(i);
  }
  scratch.contacts.impulse.resize(contacts.size());
  scratch.split.gains.resize(2 * contacts.size());
  scratch.split.energy.resize(2 * contacts.size());
  scratch.split.encounters.resize(contacts.size());
  scratch.split.materials.resize(contacts.size());
  scratch.split.met.assign(contacts.size(), 0);
  scratch.split.resting.resize(contacts.size());
}

}  // namespace

Status compute_impulses(WorldState& state, Scratch& scratch, double dt_s) {
  reset_gains(scratch, state.bodies.size());
  reset_parts(scratch.contacts, state.bodies.size(), scratch.split);
  for (int round = 0;; ++round) {
    if (Status ok = add_collisions(state, scratch, round, dt_s); !ok.ok()) return ok;
    if (!raise_parts(state, scratch, round)) break;
    take_back_gains(scratch);
  }
  return {};
}

void hash_compute_impulses(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  const Vec3Column& impulse = scratch.contacts.impulse;
  for (const auto* column : {&impulse.x, &impulse.y, &impulse.z}) hasher.add(std::span<const double>(*column));
  add_touched(scratch, hasher, [&](GatheredNumbers& numbers, BodyIndex i) {
    const Gain& gain = scratch.gains[i];
    for (const Vec3& part : {gain.velocity, gain.spin, gain.way_back}) numbers.add(part);
  });
  hasher.add(std::span<const std::uint8_t>(scratch.touched));
  hasher.add(std::span<const std::uint8_t>(scratch.hit));
}

}  // namespace tumble::sim
