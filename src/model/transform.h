#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "src/model/scene.h"

/// Symmetries of the simulation: what they do to a scene and to a state. They are exact: a reflection only changes
/// signs, a shift by whole grid steps only adds, and names mean nothing.
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

  /// An odd number of mirrors.
  [[nodiscard]] bool reflects() const { return mirror_x ^ mirror_y ^ swap_xy; }
  /// Changes nothing.
  [[nodiscard]] bool identity() const;
  friend bool operator==(const Transform&, const Transform&) = default;
};

/// "mirror x, shift 1024,-512.5, permute 7"; "identity" for none.
std::string to_string(const Transform& transform);

/// Old name to new name for every body of a scene, those that its inputs throw in included. The set of names stays.
using IdMap = std::map<BodyId, BodyId>;
IdMap ids_under(const SceneDef& scene, const Transform& transform);

/// The new name of a body; one that the map does not know keeps its own.
BodyId image_of(BodyId id, const IdMap& ids);
BoxDef image_of(const BoxDef& box, const Transform& transform, const IdMap& ids);
Command image_of(const Command& command, const Transform& transform, const IdMap& ids);

/// The transformed scene. Positions and velocities are rounded to their grids first, as state 0 has them, so a world
/// made of the image starts as the exact image of the world made of the scene.
SceneDef image_of(const SceneDef& scene, const Transform& transform, const IdMap& ids);

/// The scene with the values that a world and its inputs would round, rounded. Orientations are left: normalising
/// commutes with every transform, but not with itself.
SceneDef on_grids(const SceneDef& scene);

}  // namespace tumble::sim
