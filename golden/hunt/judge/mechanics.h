#pragma once

#include <cstdint>
#include <vector>

#include "golden/hunt/judge/trace.h"
#include "src/kernels/box_frame.h"

/// Mechanics of a state, written again for laws that judge the engine's own. Angular momenta are about the world's
/// origin unless said.
namespace tumble::hunt {

sim::BoxFrame frame_of(const sim::Bodies& bodies, sim::BodyIndex i);

/// Moments of inertia from mass and half extents, kg·m², about own axes; not the state's.
sim::Vec3 moments_of(const sim::Bodies& bodies, sim::BodyIndex i);

sim::Vec3 spin_momentum(const sim::Bodies& bodies, sim::BodyIndex i);  ///< kg·m²/s, R I Rᵀ ω
double spin_energy(const sim::Bodies& bodies, sim::BodyIndex i);       ///< J
double half_diagonal(const sim::Bodies& bodies, sim::BodyIndex i);     ///< m

/// Momentum and angular momentum of several bodies, and the magnitudes that errors are measured against.
struct Momentum {
  sim::Vec3 linear = sim::Vec3::Zero();   ///< kg·m/s
  sim::Vec3 angular = sim::Vec3::Zero();  ///< kg·m²/s
  sim::Vec3 first = sim::Vec3::Zero();    ///< kg·m, Σ m x
  double mass = 0;                        ///< kg
};
Momentum momentum_of(const sim::Bodies& bodies, const std::vector<sim::BodyId>& ids);

/// Bodies that met one another in a step, directly or through others; `fixed`: one of them met ground, a static body or
/// a frozen one, or froze or woke.
struct TouchingGroup {
  std::vector<sim::BodyId> bodies;  ///< ascending
  bool fixed = false;
};

/// The bodies of a step that are not static in groups, those that met nobody alone.
std::vector<TouchingGroup> groups_of(const Trace& trace, std::size_t step);

/// The deepest overlap in a state, m, and the two bodies; the ground counts.
struct Overlap {
  double depth = 0;
  sim::BodyId a = kGroundId, b = kGroundId;
  double thinnest = 0;  ///< m, the least edge of the two
};
/// Every overlap of a state, those of two static bodies left out.
std::vector<Overlap> overlaps_of(const sim::WorldState& state);
/// The overlap that is deepest against the thinnest edge of its two boxes.
Overlap worst_overlap(const sim::WorldState& state);

/// Whether one of these bodies begins a step so deep in something that the step lifts it out, and lets it pay with its
/// speed.
bool is_parted(const sim::WorldState& state, const std::vector<sim::BodyId>& ids);

/// Whether no box begins deeper than `depth` in another or in the ground, thrown ones included.
bool begins_apart(const Trace& trace, double depth);

}  // namespace tumble::hunt
