#pragma once

#include <algorithm>
#include <cmath>

#include "tumble/sim/manifold.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Sets the friction and the restitution of a manifold from the materials of what it joins (a, b).
inline void set_materials(const WorldState& state, Manifold& m) {
  const Bodies& bodies = state.bodies;
  const WorldDef& def = state.def;
  const bool ground = m.a == kGround;
  const double f = ground ? def.ground_material.friction : bodies.friction[m.a];
  const double fd = ground ? def.ground_material.friction_dynamic : bodies.friction_dynamic[m.a];
  const double e = ground ? def.ground_material.restitution : bodies.restitution[m.a];
  m.friction = std::sqrt(f * bodies.friction[m.b]);
  m.friction_dynamic = std::sqrt(fd * bodies.friction_dynamic[m.b]);
  m.restitution = std::max(e, bodies.restitution[m.b]);
}

}  // namespace tumble::sim
