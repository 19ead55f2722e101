#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "tumble/sim/scene.h"

/// Symmetries of the simulation, applied to scenes and states. Each is exact: a reflection changes only signs, a shift
/// by whole grid steps adds exactly, and no result depends on the names of bodies.
namespace tumble::sim {

/// A reflection, a horizontal shift and new names for the bodies, in this order.
struct Transform {
  bool mirror_x = false;
  bool mirror_y = false;
  bool swap_xy = false;                                 ///< after the mirrors: a mirror in the vertical plane x = y
  Vec3 shift = {0, 0, 0};                               ///< m, whole steps of PositionGrid
  std::optional<std::uint64_t> permute = std::nullopt;  ///< seed of the new names; none: every body keeps its name

  [[nodiscard]] Vec3 vector(const Vec3& v) const;        ///< velocities, impulses, gravity
  [[nodiscard]] Vec3 point(const Vec3& v) const;         ///< positions
  [[nodiscard]] Vec3 axial_vector(const Vec3& w) const;  ///< spins: a reflection turns them round
  [[nodiscard]] Quat orientation(const Quat& q) const;
  [[nodiscard]] Vec3 extents(const Vec3& size) const;  ///< edge lengths

  /// Whether the number of mirrors is odd.
  [[nodiscard]] bool reflects() const { return mirror_x ^ mirror_y ^ swap_xy; }
  /// Whether the transform changes nothing.
  [[nodiscard]] bool identity() const;
  friend bool operator==(const Transform&, const Transform&) = default;
};

/// "mirror x, shift 1024,-512.5, permute 7"; "identity" for none.
std::string to_string(const Transform& transform);

/// Old id to new id for every body of a scene, thrown bodies included. The set of ids stays.
using IdMap = std::map<BodyId, BodyId>;
IdMap ids_under(const SceneDef& scene, const Transform& transform);

/// The new id of a body; an id that the map lacks stays.
BodyId image_of(BodyId id, const IdMap& ids);
BoxDef image_of(const BoxDef& box, const Transform& transform, const IdMap& ids);
Command image_of(const Command& command, const Transform& transform, const IdMap& ids);

/// The transformed scene. Positions and velocities are rounded to the grids first, as in state 0, so that transforming
/// a scene and making a world gives the bits of making a world and transforming the state.
SceneDef image_of(const SceneDef& scene, const Transform& transform, const IdMap& ids);

/// The scene with positions and velocities rounded as create_world() and the inputs round them. Orientations stay as
/// they are: normalising commutes with every transform, but normalising twice is not normalising once.
SceneDef on_grids(const SceneDef& scene);

}  // namespace tumble::sim
