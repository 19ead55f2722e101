#include "src/thesis/ground/ground_collisions.h"

#include <cstddef>

#include "src/math/grid.h"
#include "src/world/body_columns.h"

namespace tumble::sim {

GroundCollisions ground_collisions(const WorldState& state, Scratch& scratch, double dt_s) {
  const Bodies& bodies = state.bodies;
  const Material& material = state.def.ground_material;
  Contacts& contacts = scratch.contacts;
  SplitScratch& split = scratch.split;
  GroundCollisions work;
  work.frames = reinterpret_cast<const double*>(scratch.frames.data());
  put_pointers(bodies.velocity, work.velocity);
  put_pointers(bodies.spin, work.spin);
  put_pointers(bodies.inverse_inertia, work.inverse_inertia);
  work.mass = bodies.mass.data();
  work.inverse_mass = bodies.inverse_mass.data();
  work.friction = bodies.friction.data();
  work.friction_dynamic = bodies.friction_dynamic.data();
  work.restitution = bodies.restitution.data();
  work.ground_friction = material.friction;
  work.ground_friction_dynamic = material.friction_dynamic;
  work.ground_restitution = material.restitution;
  work.slip_speed = state.def.slip_speed;
  const Vec3 gained = VelocityGrid::round(Vec3(state.def.gravity * dt_s));
  for (int k = 0; k < 3; ++k) work.gained[k] = gained[k];
  work.dt_s = dt_s;
  work.body = contacts.a.data();
  put_pointers(contacts.r_a, work.r);
  work.patch = doubles_of(contacts.patch).data();
  work.patch_end = contacts.patch_end.data();
  put_pointers(contacts.impulse, work.impulse);
  static_assert(sizeof(Gain) == GroundCollisions::kGainDoubles * sizeof(double));
  static_assert(sizeof(PairMaterial) == GroundCollisions::kMaterialDoubles * sizeof(double));
  static_assert(sizeof(Encounter) == GroundCollisions::kEncounterDoubles * sizeof(double));
  work.gains = reinterpret_cast<double*>(split.gains.data());
  work.energy = split.energy.data();
  work.materials = reinterpret_cast<double*>(split.materials.data());
  work.approach = reinterpret_cast<double*>(split.encounters.data()) + offsetof(Encounter, approach) / sizeof(double);
  work.resting = split.resting.data();
  return work;
}

}  // namespace tumble::sim
