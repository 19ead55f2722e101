#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Computes the impulse of every collision from the velocities before all collisions; applies none (thesis III.C).
/// Reads:  contacts; velocity, spin, orientation (through frames), masses, material
/// Writes: contacts.impulse; velocity_gain, spin_gain, gain_total, touched
/// Errors: a gain that is not finite or beyond limits.h; gains of a body that together are beyond kGainTotalMax
/// Order:  each gain is rounded to the velocity grid, so their sums are exact in any order
/// Source: thesis III.B, eq. 3.1 and Coulomb friction. Differs: 3.1 as printed has the wrong sign for B's rotation; the
///         signs here are those of Baraff and Witkin (docs/thesis.md). Parting bodies get no impulse. An impulse that
///         would add energy, by restitution and friction together, is shortened until it adds none (III.E). Where
///         several collisions of a body would push too far together, each meets a part of its mass (split_mass.h).
Status compute_impulses(WorldState& state, Scratch& scratch, double dt_s);
void hash_compute_impulses(const WorldState& state, const Scratch& scratch, Hasher& hasher);

/// One body of a contact; an immovable body has zeros.
struct ContactBody {
  Vec3 velocity = Vec3::Zero();  ///< m/s
  Vec3 spin = Vec3::Zero();      ///< rad/s
  double inverse_mass = 0;       ///< 1/kg
  Vec3 inverse_inertia = Vec3::Zero();
  Axes axes = axes_of(Quat{});
  Vec3 r = Vec3::Zero();  ///< collision point from the centre of mass, m
};

struct PairMaterial {
  double friction = 0, friction_dynamic = 0, restitution = 0;
  double slip_speed = 0;  ///< m/s
};

/// Equation 3.1 with friction: the impulse (N·s) on b; a receives the opposite. normal: unit, from a to b.
Vec3 collision_impulse(const ContactBody& a, const ContactBody& b, const Vec3& normal, const PairMaterial& material);

/// The change of spin by an impulse at r, rad/s.
Vec3 spin_gain_of(const ContactBody& body, const Vec3& impulse);

}  // namespace tumble::sim
