#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "src/model/command_fields.h"
#include "tumble/replay/field_value.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/scene.h"

/// The parameters of a world and the values of bodies and inputs by the names that scenes and reports give them.
namespace tumble::replay {

/// A value as reports print it: a flag is "true" or "false", a method its name.
inline FieldValue field_value(double value) { return value; }
inline FieldValue field_value(bool value) { return std::string(value ? "true" : "false"); }
inline FieldValue field_value(sim::Method value) { return std::string(name_of(value)); }
template <class Whole>
requires std::is_unsigned_v<Whole> FieldValue field_value(Whole value) { return std::uint64_t{value}; }

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

using NamedValues = std::vector<std::pair<std::string, FieldValue>>;

/// The parameters of a world, in the order of for_each_parameter(). The hash of a state does not tell the two zeros of
/// gravity apart, so neither does this list.
inline NamedValues parameters_of(sim::WorldDef def) {
  def.gravity = sim::plus_zero(def.gravity);
  NamedValues list;
  for_each_parameter(def, [&](const char* name, const auto& value) { list.emplace_back(name, field_value(value)); });
  return list;
}

/// The values of a Command or a BoxDef, in the order of for_each_value().
template <class Whole>
NamedValues values_of(const Whole& whole) {
  NamedValues list;
  for_each_value(whole,
                 [&](const std::string& name, const auto& value) { list.emplace_back(name, field_value(value)); });
  return list;
}

}  // namespace tumble::replay
