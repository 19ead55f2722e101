#pragma once

#include <concepts>
#include <type_traits>
#include <utility>
#include <variant>

#include "tumble/sim/scene.h"

/// The one list of the fields of every input. Hash, log, comparison and transform walk this list, so none of them can
/// miss a field: a member added to a struct of scene.h no longer compiles here, and a field added here no longer
/// compiles in a walk that has no rule for its tag or its role.
namespace tumble::sim {

/// The roles of values: a transform treats all values of one role alike. A tag of `field` derives from its role.
namespace role {
struct Body {};      ///< BodyId: names the body that the input is about
struct Plain {};     ///< a number or a flag that no symmetry touches
struct Extents {};   ///< Vec3: edge lengths, m
struct Point {};     ///< Vec3: a place, m; rounded to PositionGrid where it enters a world
struct Rotation {};  ///< Quat: an orientation
struct Velocity {};  ///< Vec3, m/s; rounded to VelocityGrid where it enters a world
struct Spin {};      ///< Vec3, rad/s, an axial vector; rounded to VelocityGrid where it enters a world
struct Vector {};    ///< Vec3: a direction with a size that is used as it is
struct Look {};      ///< nothing that happens depends on it
struct Part {};      ///< a struct with fields of its own; for_each_field() walks it
}  // namespace role

/// The tags of the fields; kName is what reports call the field.
namespace field {
// clang-format off
struct Id              : role::Body     { static constexpr const char* kName = "id"; };
struct Size            : role::Extents  { static constexpr const char* kName = "size"; };
struct Mass            : role::Plain    { static constexpr const char* kName = "mass"; };
struct Static          : role::Plain    { static constexpr const char* kName = "static"; };
struct Position        : role::Point    { static constexpr const char* kName = "position"; };
struct Orientation     : role::Rotation { static constexpr const char* kName = "orientation"; };
struct Velocity        : role::Velocity { static constexpr const char* kName = "velocity"; };
struct Spin            : role::Spin     { static constexpr const char* kName = "spin"; };
struct Friction        : role::Plain    { static constexpr const char* kName = "friction"; };
struct FrictionDynamic : role::Plain    { static constexpr const char* kName = "friction_dynamic"; };
struct Restitution     : role::Plain    { static constexpr const char* kName = "restitution"; };
struct Texture         : role::Look     { static constexpr const char* kName = "texture"; };
struct Frozen          : role::Plain    { static constexpr const char* kName = "frozen"; };
struct Origin          : role::Look     { static constexpr const char* kName = "origin"; };
struct Impulse         : role::Vector   { static constexpr const char* kName = "impulse"; };
struct AtCentre        : role::Plain    { static constexpr const char* kName = "at_centre"; };
struct At              : role::Point    { static constexpr const char* kName = "at"; };
struct Gravity         : role::Vector   { static constexpr const char* kName = "gravity"; };
struct Dt              : role::Plain    { static constexpr const char* kName = "dt"; };
struct Box             : role::Part     { static constexpr const char* kName = "box"; };
struct Material        : role::Part     { static constexpr const char* kName = "material"; };
// clang-format on
}  // namespace field

template <class Struct, class Wanted>
concept MaybeConst = std::same_as<std::remove_const_t<Struct>, Wanted>;

// for_each_field(struct, visit) calls visit(tag, member) for every member, in the order of the struct. Chain and log
// depend on this order: a new field goes to the end of its struct. Each structured binding names all members, so an
// added one stops the compiler.

template <MaybeConst<Material> M, class Visit>
void for_each_field(M& material, Visit&& visit) {
  auto& [friction, friction_dynamic, restitution, texture] = material;
  visit(field::Friction{}, friction);
  visit(field::FrictionDynamic{}, friction_dynamic);
  visit(field::Restitution{}, restitution);
  visit(field::Texture{}, texture);
}

template <MaybeConst<BoxDef> B, class Visit>
void for_each_field(B& box, Visit&& visit) {
  auto& [id, size, mass, is_static, position, orientation, velocity, spin, material, frozen, origin] = box;
  visit(field::Id{}, id);
  visit(field::Size{}, size);
  visit(field::Mass{}, mass);
  visit(field::Static{}, is_static);
  visit(field::Position{}, position);
  visit(field::Orientation{}, orientation);
  visit(field::Velocity{}, velocity);
  visit(field::Spin{}, spin);
  visit(field::Material{}, material);
  visit(field::Frozen{}, frozen);
  visit(field::Origin{}, origin);
}

template <MaybeConst<Throw> C, class Visit>
void for_each_field(C& command, Visit&& visit) {
  auto& [box] = command;
  visit(field::Box{}, box);
}

template <MaybeConst<Push> C, class Visit>
void for_each_field(C& command, Visit&& visit) {
  auto& [id, impulse, at_centre, at] = command;
  visit(field::Id{}, id);
  visit(field::Impulse{}, impulse);
  visit(field::AtCentre{}, at_centre);
  visit(field::At{}, at);
}

template <MaybeConst<Remove> C, class Visit>
void for_each_field(C& command, Visit&& visit) {
  auto& [id] = command;
  visit(field::Id{}, id);
}

template <MaybeConst<Wake> C, class Visit>
void for_each_field(C& command, Visit&& visit) {
  auto& [id] = command;
  visit(field::Id{}, id);
}

template <MaybeConst<SetVelocity> C, class Visit>
void for_each_field(C& command, Visit&& visit) {
  auto& [id, velocity, spin] = command;
  visit(field::Id{}, id);
  visit(field::Velocity{}, velocity);
  visit(field::Spin{}, spin);
}

template <MaybeConst<SetGravity> C, class Visit>
void for_each_field(C& command, Visit&& visit) {
  auto& [gravity] = command;
  visit(field::Gravity{}, gravity);
}

template <MaybeConst<SetDt> C, class Visit>
void for_each_field(C& command, Visit&& visit) {
  auto& [dt] = command;
  visit(field::Dt{}, dt);
}

/// The fields of whichever input a Command is.
template <MaybeConst<Command> C, class Visit>
void for_each_field(C& command, Visit&& visit) {
  std::visit([&](auto& input) { for_each_field(input, visit); }, command);
}

/// Calls visit(tag, value) for the values that change what happens, parts taken apart: without looks and origins, and
/// without the point of a push that goes through the centre of mass. `whole`: a Command or a BoxDef.
template <class Whole, class Visit>
void for_each_effect(Whole& whole, Visit&& visit) {
  bool at_centre = false;
  const auto walk = [&](const auto& self, auto& part) -> void {
    for_each_field(part, [&](auto tag, auto& value) {
      using Tag = decltype(tag);
      if constexpr (std::derived_from<Tag, role::Part>) {
        self(self, value);
      } else if constexpr (!std::derived_from<Tag, role::Look>) {
        if constexpr (std::same_as<Tag, field::AtCentre>) at_centre = value;
        if (std::same_as<Tag, field::At> && at_centre) return;
        visit(tag, value);
      }
    });
  };
  walk(walk, whole);
}

}  // namespace tumble::sim
