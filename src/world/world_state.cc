#include "tumble/sim/world_state.h"

#include <algorithm>

namespace tumble::sim {
namespace {

void add(Hasher& hasher, const std::vector<double>& column) { hasher.add(std::span<const double>(column)); }
void add(Hasher& hasher, const std::vector<std::uint8_t>& column) { hasher.add(std::span<const std::uint8_t>(column)); }
void add(Hasher& hasher, const std::vector<std::uint16_t>& column) {
  hasher.add(std::span<const std::uint16_t>(column));
}
void add(Hasher& hasher, const std::vector<BodyIndex>& column) { hasher.add(std::span<const BodyIndex>(column)); }
void add(Hasher& hasher, const Vec3Column& column) {
  add(hasher, column.x);
  add(hasher, column.y);
  add(hasher, column.z);
}
void add(Hasher& hasher, const Vec3& v) {
  hasher.add(v.x());
  hasher.add(v.y());
  hasher.add(v.z());
}

void add_visible(Hasher& hasher, const Bodies& bodies) {
  hasher.add(std::span<const BodyId>(bodies.id));
  add(hasher, bodies.position);
  add(hasher, bodies.orientation.w);
  add(hasher, bodies.orientation.x);
  add(hasher, bodies.orientation.y);
  add(hasher, bodies.orientation.z);
  add(hasher, bodies.velocity);
  add(hasher, bodies.spin);
  add(hasher, bodies.frozen);
}

void add_def(Hasher& hasher, const WorldDef& def) {
  hasher.add(static_cast<std::uint64_t>(def.method));
  hasher.add(static_cast<std::uint64_t>(method_version(def.method)));
  hasher.add(def.dt);
  hasher.add(static_cast<std::uint64_t>(def.substeps));
  hasher.add(static_cast<std::uint64_t>(def.split_collisions));
  add(hasher, plus_zero(def.gravity));
  hasher.add(static_cast<std::uint64_t>(def.ground));
  hasher.add(static_cast<std::uint64_t>(def.freezing));
  for (const double value :
       {def.freeze_energy, def.freeze_time, def.slip_speed, def.air_drag, def.ground_material.friction,
        def.ground_material.friction_dynamic, def.ground_material.restitution}) {
    hasher.add(value);
  }
}

}  // namespace

std::optional<BodyIndex> Bodies::find(BodyId wanted) const {
  const auto at = std::lower_bound(id.begin(), id.end(), wanted);
  if (at == id.end() || *at != wanted) return std::nullopt;
  return static_cast<BodyIndex>(at - id.begin());
}

std::uint32_t method_version(Method method) {
  switch (method) {
    case Method::kThesis:
      return 7;
    case Method::kLayered:
      return 21;
  }
  return 0;
}

Hash128 state_hash(const Bodies& bodies) {
  Hasher hasher;
  add_visible(hasher, bodies);
  return hasher.digest();
}

Hash128 continuation_hash(const WorldState& state) {
  Hasher hasher;
  hasher.add(state.step);
  add_def(hasher, state.def);
  const Bodies& bodies = state.bodies;
  hasher.add(static_cast<std::uint64_t>(bodies.size()));
  add_visible(hasher, bodies);
  for (const auto* column : {&bodies.low_energy_time, &bodies.mass, &bodies.inverse_mass, &bodies.friction,
                             &bodies.friction_dynamic, &bodies.restitution}) {
    add(hasher, *column);
  }
  add(hasher, bodies.half_extent);
  add(hasher, bodies.inertia);
  add(hasher, bodies.inverse_inertia);
  add(hasher, bodies.is_static);
  hasher.add(static_cast<std::uint64_t>(state.pairs.size()));
  add(hasher, state.pairs.a);
  add(hasher, state.pairs.b);
  add(hasher, state.pairs.planes);
  add(hasher, state.contact_objects.body);
  add(hasher, state.contact_objects.object);
  const ContactMemory& memory = state.contact_memory;
  hasher.add(static_cast<std::uint64_t>(memory.size()));
  for (const auto* column : {&memory.a, &memory.b, &memory.count, &memory.feature}) add(hasher, *column);
  add(hasher, memory.friction);
  add(hasher, memory.twist);
  add(hasher, memory.impulse);
  return hasher.digest();
}

Energy energy_of(const WorldState& state, BodyIndex i) {
  const Bodies& bodies = state.bodies;
  if (bodies.is_static[i] != 0) return {};
  return {bodies.frozen[i] == 0 ? kinetic_energy(bodies, i) : 0,
          -(bodies.mass[i] * dot(state.def.gravity, bodies.position[i]))};
}

Energy total_energy(const WorldState& state) {
  Energy energy;
  for (BodyIndex i = 0; i < state.bodies.size(); ++i) {
    const Energy of = energy_of(state, i);
    energy.kinetic += of.kinetic;
    energy.potential += of.potential;
  }
  return energy;
}

}  // namespace tumble::sim
