#pragma once

#include <cstdint>

#include "src/kernels/body_kernels.h"
#include "src/kernels/lane_width.h"
#include "src/math/half_turn.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Position, orientation, velocity and spin of a body after a free flight.
struct Flight {
  Vec3 position;
  Quat orientation;
  Vec3 velocity, spin;
};

/// Free flight of body i for dt_s under the state's gravity and air drag.
/// Source: ballistic rule x += ½ (v₀ + v₁) dt, exact under gravity. Even rotation: half_turn.h. Uneven rotation:
///         implicit midpoint in the body's frame with a Cayley map (Austin, Krishnaprasad and Wang 1993). The map keeps
///         angular momentum and kinetic energy and needs no trigonometry; Newton's method solves it, which long bars
///         need. Two corrections make the map right to the fourth order (free_flight.cc).
Flight free_flight(const WorldState& state, BodyIndex i, double dt_s);

/// Moves the bodies of `rows` in free flight that are neither frozen, static nor `in_contact` (null: none is). Gives
/// the bits of free_flight, in any lane width.
void integrate_free(WorldState& state, LaneWidth lanes, Rows rows, const std::uint8_t* in_contact, double dt_s);

/// An orientation after a turn, and the spin that keeps R I Rᵀ w.
struct Rotation {
  Quat orientation;
  Vec3 spin;
};
/// The turn of a body with different moments of inertia.
Rotation rotate_unevenly(const Quat& orientation, const Vec3& spin, const Vec3& inertia, const Vec3& inverse_inertia,
                         double dt_s);
/// The turn of any body; inertia and inverse_inertia about its own axes.
inline Rotation rotate_freely(const Quat& orientation, const Vec3& spin, const Vec3& inertia,
                              const Vec3& inverse_inertia, double dt_s) {
  if (turns_evenly(inertia)) {
    return {turned(orientation, spin * (0.5 * dt_s)), spin};
  }
  return rotate_unevenly(orientation, spin, inertia, inverse_inertia, dt_s);
}

}  // namespace tumble::sim
