#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "tumble/sim/ids.h"
#include "tumble/sim/rotation.h"
#include "tumble/sim/vec.h"

/// The scene and the inputs of a session as plain data: the whole input of a run. SI units; world axes are right-handed
/// with z up; orientations are unit quaternions (w, x, y, z); spins are in rad/s about world axes.
namespace tumble::sim {

/// The method of a step. `kThesis`: chapter III of the thesis. `kLayered`: the solver for standing stacks.
enum class Method : std::uint8_t { kThesis = 0, kLayered = 1 };

/// The scene format's words for the methods, in the order of Method.
inline constexpr std::array<const char*, 2> kMethodNames = {"thesis", "layered"};
inline const char* name_of(Method method) { return kMethodNames[static_cast<std::size_t>(method)]; }

/// The picture of a surface; the simulation never reads a texture.
enum class Texture : std::uint8_t { kCrate = 0, kBrick = 1, kWood = 2, kConcrete = 3, kWhite = 4 };

/// The scene format's words for the textures, in the order of Texture.
inline constexpr std::array<const char*, 5> kTextureNames = {"crate", "brick", "wood", "concrete", "white"};
inline const char* name_of(Texture texture) { return kTextureNames[static_cast<std::size_t>(texture)]; }

struct Material {
  double friction = 0.4;          ///< static coefficient; a pair uses the geometric mean
  double friction_dynamic = 0.4;  ///< sliding coefficient; likewise
  double restitution = 0.2;       ///< 0 … 1; a pair uses the larger
  Texture texture = Texture::kCrate;
  friend bool operator==(const Material&, const Material&) = default;
};

/// The table of the scene that made a body, and the place in the table. Reports and metrics name rows and columns.
struct Origin {
  enum class Kind : std::uint8_t { kBox = 0, kGrid = 1, kTower = 2, kPyramid = 3, kWall = 4, kPile = 5, kInput = 6 };
  Kind kind = Kind::kBox;
  std::uint32_t table = 0;  ///< 0-based: the first, second, … [[grid]] of the scene
  std::uint32_t row = 0;    ///< grid row; course of a wall or pyramid, height in a tower, layer of a pile
  std::uint32_t column = 0;
  friend bool operator==(const Origin&, const Origin&) = default;
};

/// The scene format's words for the tables that make bodies, in the order of Origin::Kind.
inline constexpr std::array<const char*, 7> kOriginNames = {"box", "grid", "tower", "pyramid", "wall", "pile", "input"};
inline const char* name_of(Origin::Kind kind) { return kOriginNames[static_cast<std::size_t>(kind)]; }

struct BoxDef {
  BodyId id = 0;
  Vec3 size = {1, 1, 1};  ///< edge lengths, m, > 0
  double mass = 1;        ///< kg, > 0
  bool is_static = false;
  Vec3 position = {0, 0, 0};  ///< centre of mass, m
  Quat orientation;           ///< normalised
  Vec3 velocity = {0, 0, 0};  ///< m/s
  Vec3 spin = {0, 0, 0};      ///< rad/s
  Material material;
  bool frozen = false;  ///< starts at rest and frozen
  Origin origin;
  friend bool operator==(const BoxDef&, const BoxDef&) = default;
};

// The inputs of a session. Nothing else changes a body between steps, and every input is logged.

/// Adds a body.
struct Throw {
  BoxDef box;
  friend bool operator==(const Throw&, const Throw&) = default;
};
/// Gives a body an impulse (N·s) at a world point or at the centre of mass. A frozen body ignores an impulse below the
/// thesis's threshold of escape.
struct Push {
  BodyId id = 0;
  Vec3 impulse = {0, 0, 0};
  bool at_centre = true;
  Vec3 at = {0, 0, 0};  ///< world point within kPositionMax, even where at_centre leaves it unused
  friend bool operator==(const Push&, const Push&) = default;
};
/// Removes a body and wakes the bodies that rested on the removed one.
struct Remove {
  BodyId id = 0;
  friend bool operator==(const Remove&, const Remove&) = default;
};
/// Wakes a frozen body, at rest.
struct Wake {
  BodyId id = 0;
  friend bool operator==(const Wake&, const Wake&) = default;
};
/// Replaces velocity (m/s) and spin (rad/s) and wakes the body.
struct SetVelocity {
  BodyId id = 0;
  Vec3 velocity = {0, 0, 0};
  Vec3 spin = {0, 0, 0};
  friend bool operator==(const SetVelocity&, const SetVelocity&) = default;
};
/// Replaces gravity (m/s²) and wakes every body.
struct SetGravity {
  Vec3 gravity = {0, 0, -9.81};
  friend bool operator==(const SetGravity&, const SetGravity&) = default;
};
/// Replaces dt (s, > 0) from the coming step on.
struct SetDt {
  double dt = 1.0 / 60;
  friend bool operator==(const SetDt&, const SetDt&) = default;
};

using Command = std::variant<Throw, Push, Remove, Wake, SetVelocity, SetGravity, SetDt>;

/// The scene format's words for the kinds of input, in the order of Command's alternatives.
inline constexpr std::array<const char*, std::variant_size_v<Command>> kCommandNames = {
    "throw", "push", "remove", "wake", "set_velocity", "set_gravity", "set_dt"};
static_assert(kCommandNames.back() != nullptr);

/// The scene format's word for a command: "throw", "push", …
inline const char* name_of(const Command& command) { return kCommandNames[command.index()]; }

/// A command that is applied before step `step` (1 … N); inputs of one step keep their order.
struct TimedCommand {
  std::uint64_t step = 1;
  Command command;
  friend bool operator==(const TimedCommand&, const TimedCommand&) = default;
};

/// The parameters of the stepper. Energy thresholds are per kilogram and fit scenes of any size.
struct WorldDef {
  Method method = Method::kLayered;
  double dt = 1.0 / 60;                ///< s
  std::uint32_t substeps = 8;          ///< thesis: a step may be halved to depth floor(log2(substeps))
  std::uint32_t split_collisions = 1;  ///< thesis: a substep that meets more collisions is halved
  Vec3 gravity = {0, 0, -9.81};        ///< m/s²
  bool ground = true;                  ///< the half-space z <= 0
  bool freezing = true;
  double freeze_energy = 0.0032;  ///< J/kg to freeze below; a frozen body escapes at twice this
  double freeze_time = 0.5;       ///< s below freeze_energy before a body freezes
  double slip_speed = 0.01;       ///< m/s; below it friction is static
  double air_drag = 0;            ///< 1/s, linear, on velocity and spin
  Material ground_material;       ///< the scene's [material]
  friend bool operator==(const WorldDef&, const WorldDef&) = default;
};

// Camera and light, for pictures; the simulation reads neither.

struct Camera {
  Vec3 position = {12, -16, 8};
  Vec3 target = {0, 0, 2};
  double fov = 40;    ///< degrees, vertical
  double focus = 18;  ///< m
  double blur = 1;    ///< strength of depth of field; 0 switches it off
  friend bool operator==(const Camera&, const Camera&) = default;
};
struct Light {
  Vec3 position = {10, -10, 25};
  Vec3 target = {0, 0, 0};
  friend bool operator==(const Light&, const Light&) = default;
};

struct SceneDef {
  std::string name;
  std::string title;
  std::string category;  ///< symmetry | energy | stacking | impact | freezing | rendering | session
  WorldDef world;
  std::uint64_t steps = 300;
  std::vector<BoxDef> boxes;         ///< ascending id
  std::vector<TimedCommand> inputs;  ///< ascending step
  Camera camera;
  Light light;
  friend bool operator==(const SceneDef&, const SceneDef&) = default;
};

}  // namespace tumble::sim
