#include "src/thesis/compute_impulses.h"

#include <algorithm>
#include <cmath>

#include "src/math/grid.h"
#include "src/thesis/split_mass.h"
#include "src/world/body_check.h"

namespace tumble::sim {
namespace {

// Slower than this there is no direction of slip to oppose, m/s.
constexpr double kSlipMin = 1e-12;

Vec3 point_velocity(const ContactBody& body) { return body.velocity + cross(body.spin, body.r); }

// The speed that a unit impulse along n at r gives the point along n by rotation: n · ((I⁻¹ (r × n)) × r), written as a
// sum of squares, so that the result is never negative.
double yield_of_rotation(const ContactBody& body, const Vec3& direction) {
  const Vec3 lever = to_body(body.axes, cross(body.r, direction));
  const Vec3& i = body.inverse_inertia;
  return (lever.x() * lever.x() * i.x() + lever.y() * lever.y() * i.y()) + lever.z() * lever.z() * i.z();
}

// J · K J in J: the impulse times the relative velocity that the impulse gives the points.
double stiffness_work(const ContactBody& a, const ContactBody& b, const Vec3& impulse) {
  return dot(impulse, impulse) * (a.inverse_mass + b.inverse_mass) +
         (yield_of_rotation(a, impulse) + yield_of_rotation(b, impulse));
}

double yield(const ContactBody& a, const ContactBody& b, const Vec3& direction) {
  return (a.inverse_mass + b.inverse_mass) + (yield_of_rotation(a, direction) + yield_of_rotation(b, direction));
}

// One part of a body, as a collision meets it.
ContactBody contact_body(const WorldState& state, const Scratch& scratch, BodyIndex i, const Vec3& r) {
  if (i == kGround) return {};
  const Bodies& bodies = state.bodies;
  const double parts = scratch.split.parts[i];
  return {bodies.velocity[i],
          bodies.spin[i],
          parts * bodies.inverse_mass[i],
          bodies.inverse_inertia[i] * parts,
          scratch.frames[i].axes,
          r};
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

// Adds the outcome of an impulse at r to the gains of body i. The impulse on a is the negative of that on b, to the
// bit. energy: of the gain (split_mass.h).
Status add_gain(WorldState& state, Scratch& scratch, BodyIndex i, const Vec3& r, const Vec3& impulse, double& energy) {
  const Bodies& bodies = state.bodies;
  scratch.touched[i] = 1;
  energy = 0;
  if (bodies.inverse_mass[i] == 0) return {};
  const BoxFrame& frame = scratch.frames[i];
  const ContactBody whole = {
      Vec3::Zero(), Vec3::Zero(), bodies.inverse_mass[i], bodies.inverse_inertia[i], frame.axes, r};
  const Vec3 velocity = VelocityGrid::round(Vec3(impulse * whole.inverse_mass));
  const Vec3 spin = VelocityGrid::round(spin_gain_of(whole, impulse));
  if (Status ok = check_gain(bodies, i, velocity, spin); !ok.ok()) return ok;
  scratch.gain_total[i] += std::max(velocity.cwiseAbs().maxCoeff(), spin.cwiseAbs().maxCoeff());
  if (Status ok = check_gains(bodies, i, scratch.gain_total[i]); !ok.ok()) return ok;
  scratch.velocity_gain.add(i, velocity);
  scratch.spin_gain.add(i, spin);
  energy = gain_energy(bodies, frame, i, velocity, spin);
  return {};
}

// Sums the gains of all bodies, from the impulses.
Status add_gains(WorldState& state, Scratch& scratch) {
  const Contacts& contacts = scratch.contacts;
  const std::size_t n = state.bodies.size();
  scratch.velocity_gain.assign(n, Vec3::Zero());
  scratch.spin_gain.assign(n, Vec3::Zero());
  scratch.gain_total.assign(n, 0);
  std::vector<double>& energy = scratch.split.energy;
  energy.assign(2 * contacts.size(), 0);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Vec3 impulse = contacts.impulse[k];
    if (Status ok = add_gain(state, scratch, contacts.a[k], contacts.r_a[k], -impulse, energy[2 * k]); !ok.ok())
      return ok;
    if (contacts.b[k] == kGround) continue;
    if (Status ok = add_gain(state, scratch, contacts.b[k], contacts.r_b[k], impulse, energy[2 * k + 1]); !ok.ok()) {
      return ok;
    }
  }
  return {};
}

// Computes the impulse of every collision; in later rounds only of bodies that were divided into more parts.
void find_impulses(const WorldState& state, Scratch& scratch, int round) {
  Contacts& contacts = scratch.contacts;
  const std::vector<std::uint8_t>& raised = scratch.split.raised;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const BodyIndex a = contacts.a[k], b = contacts.b[k];
    if (round > 0 && raised[a] == 0 && (b == kGround || raised[b] == 0)) continue;
    const ContactBody on_a = contact_body(state, scratch, a, contacts.r_a[k]);
    const ContactBody on_b = contact_body(state, scratch, b, contacts.r_b[k]);
    contacts.impulse.set(k, collision_impulse(on_a, on_b, contacts.normal[k], pair_material(state, a, b)));
  }
}

}  // namespace

Vec3 spin_gain_of(const ContactBody& body, const Vec3& impulse) {
  const Vec3 turn = to_body(body.axes, cross(body.r, impulse));
  return to_world(body.axes, turn.cwiseProduct(body.inverse_inertia));
}

Vec3 collision_impulse(const ContactBody& a, const ContactBody& b, const Vec3& normal, const PairMaterial& material) {
  const Vec3 relative = point_velocity(b) - point_velocity(a);
  const double approach = dot(relative, normal);
  if (approach >= 0) return Vec3::Zero();
  const double along_normal = -(1 + material.restitution) * approach / yield(a, b, normal);
  Vec3 impulse = normal * along_normal;
  const Vec3 slip = relative - normal * approach;
  const double slip_speed = length(slip);
  if (slip_speed > kSlipMin) {
    const Vec3 tangent = slip / slip_speed;
    const double to_stop = slip_speed / yield(a, b, tangent);
    const double friction = slip_speed < material.slip_speed ? material.friction : material.friction_dynamic;
    impulse -= tangent * std::min(to_stop, friction * along_normal);
  }
  // The collision changes the kinetic energy by J·u + ½ J·KJ. Equation 3.1 alone keeps the sum negative, but friction
  // is computed on its own, and off centre each of the two impulses changes the speed that the other has to stop.
  // Scaling J by −2 J·u / J·KJ brings the sum back to zero.
  const double spent = -2 * dot(impulse, relative), gained = stiffness_work(a, b, impulse);
  return gained > spent ? Vec3(impulse * (spent / gained)) : impulse;
}

Status compute_impulses(WorldState& state, Scratch& scratch, double /*dt_s*/) {
  scratch.touched.assign(state.bodies.size(), 0);
  scratch.contacts.impulse.resize(scratch.contacts.size());
  reset_parts(scratch.split, state.bodies.size());
  int round = 0;
  do {
    find_impulses(state, scratch, round);
    if (Status ok = add_gains(state, scratch); !ok.ok()) return ok;
  } while (raise_parts(state, scratch, round++));
  return {};
}

void hash_compute_impulses(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  const Vec3Column& impulse = scratch.contacts.impulse;
  for (const auto* column : {&impulse.x, &impulse.y, &impulse.z}) hasher.add(std::span<const double>(*column));
  for (const auto* gain : {&scratch.velocity_gain, &scratch.spin_gain}) {
    for (const auto* column : {&gain->x, &gain->y, &gain->z}) hasher.add(std::span<const double>(*column));
  }
  hasher.add(std::span<const std::uint8_t>(scratch.touched));
}

}  // namespace tumble::sim
