#pragma once

#include <string>
#include <type_traits>

#include "src/model/command_fields.h"
#include "tumble/sim/scene.h"

/// The parameters of a world and the values of bodies and inputs by the names that scenes and reports give them.
namespace tumble::replay {

/// Calls visit(name, value) for every parameter that a step depends on: doubles, whole numbers and flags. A member
/// added to WorldDef no longer compiles here.
template <class Def, class Visit>
void for_each_parameter(Def& def, Visit&& visit) {
  auto& [method, dt, substeps, split_collisions, gravity, ground, freezing, freeze_energy, freeze_time, slip_speed,
         air_drag, ground_material] = def;
  visit("world.method", method);
  visit("world.dt", dt);
  visit("world.substeps", substeps);
  visit("world.split_collisions", split_collisions);
  visit("world.gravity.x", gravity.x());
  visit("world.gravity.y", gravity.y());
  visit("world.gravity.z", gravity.z());
  visit("world.ground", ground);
  visit("world.freezing", freezing);
  visit("world.freeze_energy", freeze_energy);
  visit("world.freeze_time", freeze_time);
  visit("world.slip_speed", slip_speed);
  visit("world.air_drag", air_drag);
  auto& [friction, friction_dynamic, restitution, texture] = ground_material;
  (void)texture;
  visit("material.friction", friction);
  visit("material.friction_dynamic", friction_dynamic);
  visit("material.restitution", restitution);
}

/// Calls visit(name, value) for every value of a Command or a BoxDef that changes a session, vectors taken apart:
/// "velocity.y". Values are doubles, flags and ids; ids are not `const double&`.
template <class Whole, class Visit>
void for_each_value(Whole& whole, Visit&& visit) {
  sim::for_each_effect(whole, [&](auto tag, auto& value) {
    using Value = std::remove_const_t<std::remove_reference_t<decltype(value)>>;
    const std::string name = decltype(tag)::kName;
    if constexpr (std::is_same_v<Value, sim::Vec3>) {
      visit(name + ".x", value.x());
      visit(name + ".y", value.y());
      visit(name + ".z", value.z());
    } else if constexpr (std::is_same_v<Value, sim::Quat>) {
      visit(name + ".w", value.w);
      visit(name + ".x", value.x);
      visit(name + ".y", value.y);
      visit(name + ".z", value.z);
    } else {
      visit(name, value);
    }
  });
}

}  // namespace tumble::replay
