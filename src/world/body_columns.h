#pragma once

#include "src/kernels/body_kernels.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Points `to` at the three columns of `from`.
template <class Double>
void put_pointers(Vec3Column& from, Double* (&to)[3]) {
  to[0] = from.x.data();
  to[1] = from.y.data();
  to[2] = from.z.data();
}

inline void put_pointers(const Vec3Column& from, const double* (&to)[3]) {
  to[0] = from.x.data();
  to[1] = from.y.data();
  to[2] = from.z.data();
}

/// Pointers to the columns of bodies; valid until a column is resized.
inline BodyColumns columns_of(Bodies& b) {
  return {b.frozen.data(),
          b.is_static.data(),
          {b.position.x.data(), b.position.y.data(), b.position.z.data()},
          {b.orientation.w.data(), b.orientation.x.data(), b.orientation.y.data(), b.orientation.z.data()},
          {b.velocity.x.data(), b.velocity.y.data(), b.velocity.z.data()},
          {b.spin.x.data(), b.spin.y.data(), b.spin.z.data()},
          {b.inertia.x.data(), b.inertia.y.data(), b.inertia.z.data()},
          {b.half_extent.x.data(), b.half_extent.y.data(), b.half_extent.z.data()}};
}

}  // namespace tumble::sim
