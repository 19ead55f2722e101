#include "src/thesis/compute_impulses.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "src/math/grid.h"
#include "src/thesis/collision_impulse.h"
#include "src/thesis/split_mass.h"
#include "src/world/body_check.h"

namespace tumble::sim {
namespace {

// One part of a body, as a collision meets it. gravity_gain: m/s in this sub-step, of a body that moves.
ContactBody contact_body(const WorldState& state, const Scratch& scratch, BodyIndex i, const Vec3& r,
                         const Vec3& gravity_gain) {
  if (i == kGround) return {};
  const Bodies& bodies = state.bodies;
  const double parts = scratch.split.parts[i];
  const Vec3 gained = bodies.moves(i) ? gravity_gain : Vec3(Vec3::Zero());
  return {bodies.velocity[i],
          bodies.spin[i],
          parts * bodies.inverse_mass[i],
          bodies.inverse_inertia[i] * parts,
          scratch.frames[i].axes,
          r,
          gained};
}

PairMaterial pair_material(const WorldState& state, BodyIndex a, BodyIndex b) {
  const Bodies& bodies = state.bodies;
  const WorldDef& def = state.def;
  const bool ground = b == kGround;
  const Material& under = def.ground_material;
  const double friction = ground ? under.friction : bodies.friction[b];
  const double dynamic = ground ? under.friction_dynamic : bodies.friction_dynamic[b];
  const double restitution = ground ? under.restitution : bodies.restitution[b];
  return {std::sqrt(bodies.friction[a] * friction), std::sqrt(bodies.friction_dynamic[a] * dynamic),
          std::max(bodies.restitution[a], restitution), def.slip_speed};
}

// The corners that touch in contact k, from the collision point.
std::span<const Vec3> patch_of(const Contacts& contacts, std::size_t k) {
  const std::uint32_t begin = k == 0 ? 0 : contacts.patch_end[k - 1];
  return std::span(contacts.patch).subspan(begin, contacts.patch_end[k] - begin);
}

// Computes every collision; in later rounds only those of bodies that were divided into more parts.
void find_collisions(const WorldState& state, Scratch& scratch, int round, double dt_s) {
  Contacts& contacts = scratch.contacts;
  const std::vector<std::uint8_t>& raised = scratch.split.raised;
  const Vec3 gravity_gain = VelocityGrid::round(Vec3(state.def.gravity * dt_s));
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const BodyIndex a = contacts.a[k], b = contacts.b[k];
    if (round > 0 && raised[a] == 0 && (b == kGround || raised[b] == 0)) continue;
    const ContactBody on_a = contact_body(state, scratch, a, contacts.r_a[k], gravity_gain);
    const ContactBody on_b = contact_body(state, scratch, b, contacts.r_b[k], gravity_gain);
    scratch.split.collisions[k] =
        collide(on_a, on_b, contacts.normal[k], pair_material(state, a, b), patch_of(contacts, k));
  }
}

// Adds the outcome of a collision to the gains of body i. sign: +1 for b, −1 for a; the impulse on a is the negative of
// that on b, to the bit. At rest friction acts evenly throughout the sub-step, as gravity does: half of the speed that
// friction takes, times the sub-step, is taken from the way as well. energy: of the gain, of a
// body with several contacts (split_mass.h).
Status add_gain(WorldState& state, Scratch& scratch, BodyIndex i, const Vec3& r, const Collision& collision,
                double sign, double dt_s, double& energy) {
  const Bodies& bodies = state.bodies;
  scratch.touched[i] = 1;
  if (!collision.resting) scratch.hit[i] = 1;
  energy = 0;
  if (bodies.inverse_mass[i] == 0) return {};
  const BoxFrame& frame = scratch.frames[i];
  ContactBody whole;
  whole.inverse_mass = bodies.inverse_mass[i];
  whole.inverse_inertia = bodies.inverse_inertia[i];
  whole.axes = frame.axes;
  whole.r = r + collision.shift;
  const Vec3 impulse = collision.impulse * sign;
  const Vec3 velocity = VelocityGrid::round(Vec3(impulse * bodies.inverse_mass[i]));
  const Vec3 spin = VelocityGrid::round(spin_gain_of(whole, impulse, collision.twist * sign));
  if (Status ok = check_gain(bodies, i, velocity, spin); !ok.ok()) return ok;
  scratch.gain_total[i] += std::max(velocity.cwiseAbs().maxCoeff(), spin.cwiseAbs().maxCoeff());
  if (Status ok = check_gains(bodies, i, scratch.gain_total[i]); !ok.ok()) return ok;
  scratch.velocity_gain.add(i, velocity);
  scratch.spin_gain.add(i, spin);
  if (collision.resting) {
    const Vec3 slowed = VelocityGrid::round(Vec3(collision.friction * (sign * bodies.inverse_mass[i])));
    scratch.way_back.add(i, PositionGrid::round(Vec3(slowed * (0.5 * dt_s))));
  }
  if (scratch.split.contacts[i] > 1) energy = gain_energy(bodies, frame, i, velocity, spin);
  return {};
}

// Sums the gains of all bodies.
Status add_gains(WorldState& state, Scratch& scratch, double dt_s) {
  const Contacts& contacts = scratch.contacts;
  const std::size_t n = state.bodies.size();
  for (Vec3Column* sum : {&scratch.velocity_gain, &scratch.spin_gain, &scratch.way_back}) sum->assign(n, Vec3::Zero());
  scratch.gain_total.assign(n, 0);
  std::vector<double>& energy = scratch.split.energy;
  energy.assign(2 * contacts.size(), 0);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Collision& collision = scratch.split.collisions[k];
    Status ok = add_gain(state, scratch, contacts.a[k], contacts.r_a[k], collision, -1, dt_s, energy[2 * k]);
    if (ok.ok() && contacts.b[k] != kGround) {
      ok = add_gain(state, scratch, contacts.b[k], contacts.r_b[k], collision, 1, dt_s, energy[2 * k + 1]);
    }
    if (!ok.ok()) return ok;
  }
  return {};
}

}  // namespace

Status compute_impulses(WorldState& state, Scratch& scratch, double dt_s) {
  const std::size_t n = state.bodies.size(), count = scratch.contacts.size();
  scratch.touched.assign(n, 0);
  scratch.hit.assign(n, 0);
  scratch.split.collisions.resize(count);
  reset_parts(scratch.contacts, n, scratch.split);
  int round = 0;
  do {
    find_collisions(state, scratch, round, dt_s);
    if (Status ok = add_gains(state, scratch, dt_s); !ok.ok()) return ok;
  } while (raise_parts(state, scratch, round++));
  scratch.contacts.impulse.resize(count);
  for (std::size_t k = 0; k < count; ++k) scratch.contacts.impulse.set(k, scratch.split.collisions[k].impulse);
  return {};
}

void hash_compute_impulses(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  const Vec3Column& impulse = scratch.contacts.impulse;
  for (const auto* column : {&impulse.x, &impulse.y, &impulse.z}) hasher.add(std::span<const double>(*column));
  for (const auto* gain : {&scratch.velocity_gain, &scratch.spin_gain, &scratch.way_back}) {
    for (const auto* column : {&gain->x, &gain->y, &gain->z}) hasher.add(std::span<const double>(*column));
  }
  hasher.add(std::span<const std::uint8_t>(scratch.touched));
  hasher.add(std::span<const std::uint8_t>(scratch.hit));
}

}  // namespace tumble::sim
