#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "src/model/scene.h"
#include "src/world/world.h"

/// Symmetries of the simulation: what they do to a scene and to a state. Exact where the scene is resolved, for then a
/// reflection only changes signs and a shift by whole grid steps only adds.
namespace tumble::test {

/// A reflection, a horizontal shift and new names for the bodies, in this order.
struct Transform {
  std::string name;
  bool mirror_x = false;
  bool mirror_y = false;
  bool swap_xy = false;
  sim::Vec3 shift = {0, 0, 0};  ///< whole steps of PositionGrid
  bool permute_ids = false;

  [[nodiscard]] sim::Vec3 vector(const sim::Vec3& v) const;        ///< velocities, impulses, gravity
  [[nodiscard]] sim::Vec3 point(const sim::Vec3& v) const;         ///< positions
  [[nodiscard]] sim::Vec3 axial_vector(const sim::Vec3& w) const;  ///< spins: a reflection turns them round
  [[nodiscard]] sim::Quat orientation(const sim::Quat& q) const;
  [[nodiscard]] sim::Vec3 extents(const sim::Vec3& size) const;  ///< edge lengths
};

/// Mirrored in x, in y, x and y swapped, shifted by (1024, −512.5, 0), ids permuted; and all of it at once.
const std::vector<Transform>& all_transforms();

/// The scene with the values that World::create and the inputs would round, rounded: state 0 is then what it says.
sim::SceneDef resolved(sim::SceneDef scene);

/// Old name to new name for every body of the scene, those thrown in later included; names stay within the same set.
using Names = std::map<sim::BodyId, sim::BodyId>;
Names names_under(const sim::SceneDef& scene, const Transform& transform, std::uint64_t seed);

sim::BoxDef image_of(const sim::BoxDef& box, const Transform& transform, const Names& names);
sim::Command image_of(const sim::Command& command, const Transform& transform, const Names& names);
sim::SceneDef image_of(const sim::SceneDef& scene, const Transform& transform, const Names& names);

/// How many bodies of `image` are not, in every bit of position, orientation, velocity, spin, frozen and time at low
/// energy, the image of their original; bodies missing on one side count.
std::size_t differing_bodies(const sim::World& original, const sim::World& image, const Transform& transform,
                             const Names& names);

}  // namespace tumble::test
