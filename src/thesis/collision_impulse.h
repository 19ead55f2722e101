#pragma once

#include <cstddef>
#include <span>

#include "src/thesis/contact_body.h"
#include "src/world/phase_scratch.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/vec.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// The impulse of a collision, on b; a receives the opposite.
struct Collision {
  Vec3 impulse = Vec3::Zero();   ///< N·s
  Vec3 friction = Vec3::Zero();  ///< N·s, the part of the impulse along the plane
  Vec3 twist = Vec3::Zero();     ///< N·m·s, an angular impulse besides, by friction
  Vec3 shift = Vec3::Zero();     ///< m, on PositionGrid: where the impulse acts, from the collision point
  Vec3 turn_a = Vec3::Zero();    ///< N·m·s, of impulse and twist about a's centre, axes of a; on a the opposite
  Vec3 turn_b = Vec3::Zero();    ///< of b
  bool resting = false;          ///< of a patch that approaches by at most twice what gravity added
};

/// The material of a contact; b may be kGround.
PairMaterial pair_material(const WorldState& state, BodyIndex a, BodyIndex b);

/// How two bodies meet. Reads of the masses only whether they are finite, so it holds for any parts of them
/// (split_mass.h). normal: unit, from a to b; corners: of the patch. Of bodies that part only `approach` is written.
void find_encounter(const ContactBody& a, const ContactBody& b, const Vec3& normal, const PairMaterial& material,
                    std::size_t corners, Encounter& met);

/// Equation 3.1 with friction, of bodies that meet so. patch: the corners that touch, from the collision point, or
/// none.
/// Friction is static while the slip that the points had before gravity acted is slower than slip_speed, or turns
/// round, and what gravity adds in one substep can be held; else dynamic. It presses by equation 3.1 without what the
/// restitution throws back of gravity's own gain.
/// A face that rubs presses harder at the corners ahead of the friction: the collision point moves along the slip, as
/// far as the patch reaches, to where friction and pressure together turn neither body against the other.
Collision collide(const ContactBody& a, const ContactBody& b, const Vec3& normal, const PairMaterial& material,
                  const Encounter& met, std::span<const Vec3> patch);

/// The same for bodies that meet at one point: their motion is in the encounter. Precondition: they approach, and no
/// corners share the load.
Collision collide_at_point(const Response& a, const Response& b, const Vec3& normal, const PairMaterial& material,
                           const Encounter& met);

/// The change of spin by an impulse at r and an angular impulse, rad/s.
Vec3 spin_gain_of(const ContactBody& body, const Vec3& impulse, const Vec3& twist = Vec3::Zero());

}  // namespace tumble::sim
