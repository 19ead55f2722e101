#pragma once

#include <cstdint>
#include <vector>

#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// The columns of a visible state, wherever they lie.
struct VisibleColumns {
  const std::vector<BodyId>& id;
  const Vec3Column& position;
  const QuatColumn& orientation;
  const Vec3Column& velocity;
  const Vec3Column& spin;
  const std::vector<std::uint8_t>& frozen;
};

/// The state hash of these columns: that of bodies which hold them.
Hash128 state_hash(const VisibleColumns& columns);

}  // namespace tumble::sim
