#pragma once

#include <optional>
#include <span>

#include "src/thesis/meeting.h"

namespace tumble::sim {

/// A collision whose corners share the load.
struct SharedLoad {
  Vec3 shift = Vec3::Zero();  ///< m, from the collision point to the middle of the load
  Impulses impulses;
};

/// Two bodies that touch along a whole patch.
struct Touch {
  const ContactBody &a, &b;
  const Vec3& normal;
  const Encounter& met;
  const PairMaterial& material;
  std::span<const Vec3> patch;
};

/// The collision of bodies of which one rests on the other with three corners or more: the corners share the load so
/// that friction and pressure together leave no tilting. None where the pressure would have to act beyond the patch.
std::optional<SharedLoad> share_load(const Touch& touch, const Meeting& meeting);

}  // namespace tumble::sim
