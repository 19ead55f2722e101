#pragma once

#include <cstdint>

namespace tumble::sim {

/// Manifolds of a batch. Eight on every machine, so that memory looks alike everywhere; a machine with narrower vectors
/// takes a batch in parts.
inline constexpr int kLanes = 8;

/// Limit of points of a manifold: corners of the reference face (4), corners of the other box (8), and crossings of the
/// face's edges with edges of the other box (4 · 12). No two points of a manifold have one feature.
inline constexpr unsigned kPointsMax = 60;

/// Bodies that move no faster than this along a contact's normal, m/s, rest on each other; faster bodies meet or part.
inline constexpr double kRestingSpeed = 0.1;

/// Slower impacts do not bounce, m/s. A contact of a fast pair rests on nothing yet, so it may bounce at less.
inline constexpr double kBounceMin = 0.5, kFastBounceMin = 1.5 * kRestingSpeed;

/// An impulse of a step counts as borne up to so many times what the step began with, or the load, and up to so many
/// weights of the lighter body for a substep. Beyond that it has stopped a hit.
inline constexpr double kBornePart = 2, kBorneWeights = 4;

/// A substep may begin with so many times what stops two bodies as they close then, where one of them rests on
/// something that rests: what lies above presses too. With all that stopped a hit in the substep before, columns that
/// land throw their top back; with once as much they sink into themselves.
inline constexpr double kHitStops = 3;

/// m of overlap that is not removed; of a box thinner than 5 cm, this part of its smallest half extent.
inline constexpr double kSlop = 0.0005, kSlopOfHalfExtent = 0.02;

/// m apart that counts as touching.
inline constexpr double kSkin = 0.0001;

/// One number for each of eight manifolds.
struct alignas(64) Lanes {
  double of[kLanes] = {};
};

/// One contact point of each manifold of a batch, with the fields of ManifoldPoint. A lane whose manifold has fewer
/// points holds zeros, which give no impulse.
struct PointBatch {
  Lanes p, q;
  Lanes load;  ///< as in ManifoldPoint; outside hard batches, part_overlaps puts the speed here that it wants, negated
  Lanes separation;
  Lanes impulse;
  Lanes peak;      ///< N·s, the largest impulse of this step; 0: the point was never hit. Sweep::kPart leaves it alone
  Lanes mass;      ///< kg, effective along the normal, with the split masses
  Lanes approach;  ///< m/s, normal velocity at the impact, to come or past; negative when closing
};

/// A body of a layer, and the entries [begin, end) that name the body's outcomes.
struct BodyOutcomes {
  std::uint32_t body = 0, begin = 0, end = 0;
};

/// The bodies of a batch's manifolds, and when each manifold was solved last. They lie apart from the batch: a visit
/// asks every manifold whether it is due, and then reads only the batches of those that are.
struct alignas(64) BatchSides {
  std::uint32_t a[kLanes] = {}, b[kLanes] = {};  ///< rows of solver_bodies; the ground is the row after the last body
  std::uint32_t visited[kLanes] = {};            ///< number of the visit that solved each manifold last (Visit)
  /// Sweeps that solve each manifold, at most 127: in push_contacts and relax_contacts, and in part_overlaps.
  std::uint8_t sweeps[kLanes] = {1, 1, 1, 1, 1, 1, 1, 1}, parting[kLanes] = {1, 1, 1, 1, 1, 1, 1, 1};
  std::uint8_t turns[kLanes] = {1, 1, 1, 1, 1, 1, 1, 1};  ///< likewise, in bounces
};
/// A value of `visited` that is never due, of lanes that are not used; larger than the number of any visit.
inline constexpr std::uint32_t kNeverDue = 0x7fffffff;

/// Up to eight manifolds of one layer, with the fields of Manifold. An unused lane holds zeros; its bodies are the
/// ground, which does not move.
struct ContactBatch {
  std::uint32_t used = 0;              ///< lanes from the left
  std::uint32_t members = 0;           ///< first of its manifolds in ContactBatches::order
  std::uint32_t first = 0, count = 0;  ///< its points
  std::uint8_t met = 0, bounces = 0;   ///< a bit a lane: a point met fast enough to bounce; and restitution makes it
  std::uint8_t hard = 0;               ///< a bit a lane: the manifold belongs to a hard island (assign_levels)
  std::uint8_t turns = 0;              ///< a bit a lane: `renew` computes the responses of the manifold anew
  std::uint8_t loose = 0;              ///< a bit a lane: of layers, touches nothing at rest, directly or by others
  bool fast = false;                   ///< of fast pairs, found anew in every substep
  bool even = false;                   ///< all its bodies turn alike about every axis and are lent nothing (`prepare`)
  bool levers_turned = false;          ///< by the last `prepare` or `move_on`, in a lane
  std::uint32_t impact = 0;            ///< where one has met, its number among the ImpactBatches
  Lanes point_count;                   ///< of each manifold
  Lanes n[3], t1[3], t2[3];
  Lanes impulse_max;  ///< N·s: points whose impulses add up to this have exact sums with impulse_magic
  // Levers, m, as they will be in the middle of the next substep. Like p and q of the points and the centre of friction
  // they turn with the bodies (contact_levers_impl.h).
  Lanes d[3], offset;
  Lanes friction, friction_dynamic, restitution;
  Lanes slop;  ///< m of overlap that is not removed
  Lanes force1, force2, twist;
  Lanes sliding;    ///< 1: has slipped in this substep, so the dynamic coefficient holds until its end
  Lanes passes_on;  ///< N·s: the normal impulse that a substep begins with; beyond it a hit was stopped (kHitStops)
  Lanes split_a, split_b;  ///< manifolds of this layer that share the body's mass
  Lanes acceleration;      ///< m/s², of b against a along n, by gravity alone
  Lanes impulse_magic;     ///< magic number (math/grid.h) of a grid that fits the lighter body
  // Computed by `prepare`, once a step.
  Lanes centre_p, centre_q, radius;  ///< m, where friction acts; m, mean distance of the points from there
  Lanes friction_inverse[6];         ///< of the 3 × 3 matrix of (t1, t2, twist): 11, 12, 13, 22, 23, 33
  Lanes response[6];                 ///< of (u, W1, W2) to the sums (S, Sq, Sp)
  Lanes relaxation;
};

/// m/s; slower impacts do not bounce.
inline double bounce_min(const ContactBatch& batch) { return batch.fast ? kFastBounceMin : kBounceMin; }

/// The work of a batch's normal impulses, where a manifold met fast. The energy that they take from the bodies is
/// exactly the sum over points of −J ½ (v before + v after), whatever else has pushed meanwhile: v of the point along
/// the normal, J all that it got. A manifold's points need the sums of contact_lanes.h alone.
struct ImpactBatch {
  std::uint32_t batch = 0;   ///< its number
  Lanes motion[3];           ///< u, W1 and W2 when the last sweeps began
  Lanes sums[3];             ///< S, Sq and Sp of the impulses then
  Lanes slip[3], forces[3];  ///< how the centre of friction slipped then, along t1, t2 and about n; friction then
  Lanes absorbed;            ///< J taken in this step until then; a bounce gives no more back than e² of it
};

}  // namespace tumble::sim
