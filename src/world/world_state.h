#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tumble/sim/hash.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/manifold.h"
#include "tumble/sim/rotation.h"
#include "tumble/sim/scene.h"
#include "tumble/sim/vec.h"

namespace tumble::sim {

/// All bodies, structure of arrays, one row a body in ascending id. A new body is an input too (throw). Hash: s state,
/// c continuation. (a): part_overlaps, find_fast_contacts, integrate_positions; (b): wake_islands, update_sleeping.
/// | column                | shape | unit      | method thesis: written by | method layered: written by        | hash |
/// |-----------------------|-------|-----------|---------------------------|-----------------------------------|------|
/// | id                    | n     |           | inputs                    | inputs                            | s c  |
/// | position              | n × 3 | m         | integrate, apply_outcomes | (a), finish_motion                | s c  |
/// | orientation           | n × 4 | w x y z   | integrate                 | (a), finish_motion                | s c  |
/// | velocity, spin        | n × 3 | m/s       | integrate, apply_outcomes | find_fast_contacts, finish_motion | s c  |
/// |                       |       | rad/s     | update_freezing, inputs   | update_sleeping, inputs           | s c  |
/// | frozen                | n     | 0 or 1    | update_freezing, inputs   | (b), inputs                       | s c  |
/// | low_energy_time       | n     | s         | update_freezing, inputs   | (b), inputs                       | c    |
/// | half_extent           | n × 3 | m         | inputs                    | inputs                            | c    |
/// | mass, inverse         | n     | kg, 1/kg  | inputs; statics inverse 0 | likewise                          | c    |
/// | inertia, inverse      | n × 3 | kg·m², 1/ | inputs, about own axes    | likewise                          | c    |
/// | friction, restitution | n     |           | inputs                    | inputs                            | c    |
/// | is_static             | n     | 0 or 1    | inputs                    | inputs                            | c    |
///
/// Positions lie on PositionGrid, velocities and spins on VelocityGrid; no column ever holds −0.0.
struct Bodies {
  std::vector<BodyId> id;
  Vec3Column position;
  QuatColumn orientation;
  Vec3Column velocity;
  Vec3Column spin;
  std::vector<std::uint8_t> frozen;

  std::vector<double> low_energy_time;

  Vec3Column half_extent;
  std::vector<double> mass;
  std::vector<double> inverse_mass;
  Vec3Column inertia;
  Vec3Column inverse_inertia;
  std::vector<double> friction;
  std::vector<double> friction_dynamic;
  std::vector<double> restitution;
  std::vector<std::uint8_t> is_static;

  [[nodiscard]] std::size_t size() const { return id.size(); }
  /// The row of a body, if it exists.
  [[nodiscard]] std::optional<BodyIndex> find(BodyId wanted) const;
  /// Whether the step moves a body: neither static nor frozen.
  [[nodiscard]] bool moves(BodyIndex i) const { return frozen[i] == 0 && is_static[i] == 0; }
  friend bool operator==(const Bodies&, const Bodies&) = default;
};

/// The Active Collision List: pairs whose AABBs overlap, ascending by (a, b), a < b, with the planes that separated
/// them last (thesis III.A). `planes` is a set of axes: bits 0–2 faces of a, 3–5 faces of b, 6 + 3i + j the edges i of
/// a and j of b. Several bits: an exact tie. 0: no plane is known.
struct PairTable {
  std::vector<BodyIndex> a;
  std::vector<BodyIndex> b;
  std::vector<std::uint16_t> planes;

  [[nodiscard]] std::size_t size() const { return a.size(); }
  void clear() {
    a.clear();
    b.clear();
    planes.clear();
  }
  friend bool operator==(const PairTable&, const PairTable&) = default;
};

/// The contact objects of frozen bodies (thesis III.D): for each body the set of lowest objects that it touched when it
/// froze. Ascending by (body, object); an object may be kGround.
struct ContactObjects {
  std::vector<BodyIndex> body;
  std::vector<BodyIndex> object;

  [[nodiscard]] std::size_t size() const { return body.size(); }
  void clear() {
    body.clear();
    object.clear();
  }
  void push_back(BodyIndex of, BodyIndex on) {
    body.push_back(of);
    object.push_back(on);
  }
  friend bool operator==(const ContactObjects&, const ContactObjects&) = default;
};

/// Everything that the future of a session depends on, and nothing else. A copy is a snapshot: a world restored from
/// the copy takes the steps of the original, to the bit.
struct WorldState {
  std::uint64_t step = 0;  ///< steps taken
  WorldDef def;            ///< with the current dt and gravity
  Bodies bodies;
  PairTable pairs;
  ContactObjects contact_objects;  ///< method thesis
  ContactMemory contact_memory;    ///< method layered
  friend bool operator==(const WorldState&, const WorldState&) = default;
};

/// The hash of the visible state: id, position, orientation, velocity, spin and frozen of all bodies. Fields and order
/// never change.
Hash128 state_hash(const Bodies& bodies);

/// The hash of everything in a WorldState, and of the method's version.
Hash128 continuation_hash(const WorldState& state);

/// The version of a method's arithmetic. Every change that moves a bit raises it.
std::uint32_t method_version(Method method);

/// True of a cube and the like: equal moments of inertia, so free flight leaves the spin as it is.
inline bool turns_evenly(const Vec3& inertia) { return inertia.x() == inertia.y() && inertia.y() == inertia.z(); }

/// Kinetic energy in J of body i, linear and rotational.
inline double kinetic_energy(const Bodies& bodies, BodyIndex i) {
  const Vec3 v = bodies.velocity[i], w = bodies.spin[i], inertia = bodies.inertia[i];
  const Vec3 w_B = turns_evenly(inertia) ? w : to_body(axes_of(bodies.orientation[i]), w);
  return 0.5 * (bodies.mass[i] * dot(v, v) + dot(w_B, w_B.cwiseProduct(inertia)));
}

/// Likewise per kilogram, J/kg: what thresholds of freezing compare.
inline double energy_per_mass(const Bodies& bodies, BodyIndex i) { return kinetic_energy(bodies, i) / bodies.mass[i]; }

/// Energies of all bodies, J; potential is −m g·x, statics count nothing. Summed in row order.
struct Energy {
  double kinetic = 0;
  double potential = 0;
};
Energy total_energy(const WorldState& state);
/// Of one body: zeros for what does not count.
Energy energy_of(const WorldState& state, BodyIndex i);

}  // namespace tumble::sim
