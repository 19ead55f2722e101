#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "src/base/ids.h"
#include "src/base/workers.h"
#include "src/kernels/box_frame.h"
#include "src/kernels/contact_batch.h"
#include "src/kernels/lane_width.h"
#include "src/math/rotation.h"
#include "src/math/vec.h"
#include "src/world/manifold.h"
#include "src/world/phase_scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Collisions found and what follows from each: the Real Collision List (thesis III.A.2), structure of arrays. Pairs
/// come first, ascending by (a, b), then bodies in the ground, ascending, with b = kGround. Points are offsets from
/// the centres of mass, on PositionGrid, with r_b = r_a − (x_b − x_a) exactly. normal points from a to b.
struct Contacts {
  std::vector<BodyIndex> a;
  std::vector<BodyIndex> b;
  std::vector<std::uint16_t> planes;  ///< the tied axes of least overlap, as in PairTable; 0 for the ground
  Vec3Column normal;
  std::vector<double> depth;  ///< m, > 0
  Vec3Column r_a;
  Vec3Column r_b;      ///< zero for the ground
  Vec3Column impulse;  ///< N·s, on b; a gets its opposite

  [[nodiscard]] std::size_t size() const { return a.size(); }
};

/// Pairs (a, b), a < b, in any order.
using FoundPairs = std::vector<std::pair<BodyIndex, BodyIndex>>;

/// What the broad phase keeps between sub-steps to be quick: the last sorted order and buffers.
struct SweepScratch {
  struct Box {
    double low1, high1, low2, high2, low3, high3;
  };
  int axis = 0;                   ///< to sweep along
  int age = 0;                    ///< sweeps since it was chosen
  std::vector<BodyIndex> order;   ///< bodies by the low end of their box along it
  std::vector<BodyIndex> judged;  ///< likewise along an axis that might be better
  std::vector<Box> boxes;         ///< extents in that order
  Vec3Column low, high;           ///< of each box's room: while it stays there, it has no other neighbours
  FoundPairs neighbours;          ///< pairs whose rooms overlap, ascending
  FoundPairs found;
  std::vector<FoundPairs> found_by;        ///< by the threads but the first
  std::vector<std::uint32_t> start, next;  ///< of each a in `partner`
  std::vector<BodyIndex> partner;
  PairTable merged;
  // In cells across the other axes (method layered).
  struct Entry {
    Box box;
    BodyIndex body;
  };
  std::vector<Entry> entries;             ///< cell by cell
  std::vector<std::uint32_t> cell_start;  ///< of each cell in `entries`
};

/// What the solver of method layered knows of a body; all zeros for what does not move. The kernels read it as a row of
/// doubles in this order.
struct alignas(128) SolverBody {
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
  double inverse_mass = 0;
  double weight = 1;               ///< of gravity's acceleration, where the solver lends the body inertia
  double inverse_inertia[6] = {};  ///< world axes: xx, xy, xz, yy, yz, zz
  double unused[2] = {};
};

/// What a manifold does to one body: a row that the kernels write and add up.
struct alignas(64) Outcome {
  double of[8] = {};
};

/// The awake manifolds as the solver takes them, layer by layer; written by prepare_manifolds.
struct ContactBatches {
  std::vector<ContactBatch> batches;
  std::vector<PointBatch> points;
  std::vector<std::uint32_t> layer_start;    ///< of each layer in `batches`
  std::vector<std::uint32_t> place;          ///< of each manifold: kLanes times its batch plus its lane
  std::vector<std::uint32_t> order;          ///< the manifolds, batch by batch
  std::vector<BodyOutcomes> touched;         ///< moving bodies that each layer touches, layer by layer
  std::vector<std::uint32_t> touched_start;  ///< of each layer in `touched`
  std::vector<std::uint32_t> entries;        ///< rows of `outcomes`, body by body
  std::vector<std::uint32_t> uses;           ///< of each body in a layer, while it is being counted
  std::vector<Outcome> outcomes;             ///< of one layer at a time
};

/// Layers that are swept equally often. Groups have no moving body in common. Written by assign_levels.
struct SweepGroup {
  std::uint32_t begin = 0, end = 0;  ///< layers
  int sweeps = 1;
  bool slender = false;  ///< islands with a slender body
};

/// Manifolds and their points.
struct ManifoldList {
  std::vector<Manifold> manifolds;
  std::vector<ManifoldPoint> points;
  std::size_t manifolds_before = 0, points_before = 0;  ///< of threads before the one that finds these
};

/// What a rejected sub-step has to put back: all that its trial phases write.
struct SavedMotion {
  Vec3Column position, velocity, spin;
  QuatColumn orientation;
  PairTable pairs;
};

/// Memory that the phases of one sub-step pass on; nothing in it outlives the step, and the future does not depend on
/// it. Kept between steps only so that a warm step does not allocate.
struct Scratch {
  std::vector<BoxFrame> frames;  ///< written by find_pairs
  Vec3Column aabb_low;           ///< written by find_pairs; on PositionGrid
  Vec3Column aabb_high;
  std::vector<std::uint8_t> framed;  ///< bodies that could not move since their boxes were put; empty between steps
  SweepScratch sweep;
  std::vector<std::uint16_t> old_planes;  ///< of each pair, those it was known with; written by find_pairs
  Contacts contacts;                      ///< written by find_planes (a, b, planes), find_contacts, compute_impulses
  Vec3Column velocity_gain;               ///< sum of impulse outcomes of each body, m/s; written by compute_impulses
  Vec3Column spin_gain;                   ///< likewise, rad/s
  Vec3Column displacement;                ///< merged separation of each body, m; written by compute_separation
  Vec3Column displacement_low;            ///< its negative parts while it is being merged
  std::vector<std::uint8_t> touched;      ///< in a real collision in this sub-step; written by compute_impulses
  // Method layered.
  std::vector<double> turning;      ///< m, how far corners may come by turning; written by find_near_pairs
  std::vector<Manifold> manifolds;  ///< in the order of the pairs; written by find_manifolds
  std::vector<ManifoldPoint> manifold_points;
  std::vector<ManifoldList> manifolds_by;  ///< by the threads that find them
  bool found_again = false;                ///< the manifolds, by wake_islands
  std::vector<std::uint32_t> level;        ///< of each body: contacts away from the ground; written by assign_levels
  std::vector<std::uint32_t> layered;      ///< manifolds that are awake, layer by layer
  std::vector<std::uint32_t> layer_start;  ///< of each layer in `layered`
  std::vector<SweepGroup> sweep_groups;    ///< islands with slender bodies, if there are any, come last
  std::vector<double> solver_mass;         ///< kg, inertia of each body in the solver; written by carry_weights
  std::vector<std::uint8_t> in_contact;    ///< moving bodies that have a manifold; written by prepare_manifolds
  std::vector<SolverBody> solver_bodies;  ///< written by prepare_manifolds, then by every sweep; the last is the ground
  ContactBatches contact_batches;
  LaneWidth lanes = LaneWidth::kWidest;  ///< shows in nothing but time
  Workers* workers = nullptr;            ///< likewise; not owned

  std::uint32_t still_steps = 0;  ///< in a row, before which nothing could move and no input came

  double removed_energy = 0;            ///< J in this step; written by apply_outcomes
  std::vector<SavedMotion> saved;       ///< one for each depth of sub-step recursion; written by step
  std::vector<BodyIndex> island_links;  ///< where Islands joins bodies, each time anew
  // Each of the one phase that it is named after.
  FreezeScratch freezing;
  WakeScratch waking;
  LevelScratch levels;
  WeightScratch weights;
  SleepScratch sleeping;
};

inline std::span<ManifoldPoint> points_of(Scratch& scratch, const Manifold& m) {
  return std::span(scratch.manifold_points).subspan(m.first, m.count);
}
inline std::span<ManifoldPoint> points_of(ManifoldList& list, const Manifold& m) {
  return std::span(list.points).subspan(m.first, m.count);
}
inline std::span<const ManifoldPoint> points_of(const Scratch& scratch, const Manifold& m) {
  return std::span(scratch.manifold_points).subspan(m.first, m.count);
}

/// The manifolds of one layer, as indices.
inline std::span<const std::uint32_t> layer_of(const Scratch& scratch, std::size_t layer) {
  const std::uint32_t begin = scratch.layer_start[layer];
  return std::span(scratch.layered).subspan(begin, scratch.layer_start[layer + 1] - begin);
}

}  // namespace tumble::sim
