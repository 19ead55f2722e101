#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "src/base/large_vector.h"
#include "src/kernels/box_frame.h"
#include "src/kernels/contacts/contact_batch.h"
#include "src/kernels/lane_width.h"
#include "src/sharing/homes.h"
#include "src/sharing/shared_blocks.h"
#include "src/world/phase_scratch.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/manifold.h"
#include "tumble/sim/rotation.h"
#include "tumble/sim/vec.h"
#include "tumble/sim/workers.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Collisions and their outcomes: the Real Collision List (thesis III.A.2), structure of arrays. Pairs come first,
/// ascending by (a, b), then bodies in the ground, ascending, with b = kGround. Points are offsets from the centres of
/// mass, on PositionGrid, with r_b = r_a − (x_b − x_a) exactly. normal points from a to b.
struct Contacts {
  std::vector<BodyIndex> a;
  std::vector<BodyIndex> b;
  std::vector<std::uint16_t> planes;  ///< tied axes of least overlap, as in PairTable; 0 for the ground
  Vec3Column normal;
  std::vector<double> depth;  ///< m, > 0
  Vec3Column r_a;
  Vec3Column r_b;                        ///< zero for the ground
  std::vector<Vec3> patch;               ///< the corners behind the planes, from the collision points, entry by entry;
                                         ///< only of bodies on the ground or on static boxes
  std::vector<std::uint32_t> patch_end;  ///< by entry, in `patch`
  Vec3Column impulse;                    ///< N·s, on b; on a the opposite

  [[nodiscard]] std::size_t size() const { return a.size(); }
};

/// Pairs (a, b), a < b, in any order.
using FoundPairs = std::vector<std::pair<BodyIndex, BodyIndex>>;

/// Memory of the broad phase between substeps, to save time: the last sorted order and buffers. A fat AABB is the AABB
/// of a box plus a margin; while every box stays inside its fat AABB, the list of neighbours stays complete.
struct SweepScratch {
  struct Box {
    double low1, high1, low2, high2, low3, high3;
  };
  int axis = 0;                                           ///< axis of the sweep
  int age = 0;                                            ///< sweeps since the axis was chosen
  std::vector<BodyIndex> order;                           ///< bodies by the low end of their boxes along the axis
  std::vector<BodyIndex> judged;                          ///< the order along an axis that might be better
  std::vector<Box> boxes;                                 ///< extents of the boxes, in that order
  Vec3Column fat_low, fat_high;                           ///< fat AABBs
  FoundPairs neighbours;                                  ///< pairs whose fat AABBs overlap, ascending
  std::vector<OwnList<FoundPairs::value_type>> found_by;  ///< by worker
  struct Extents {
    double lowest = 0, highest = 0, sum = 0;  ///< m; of ends, and of the extents of boxes
  };
  std::vector<Extents> extents;      ///< by worker and axis
  std::vector<std::uint32_t> start;  ///< by body a, in `partner`
  std::vector<std::uint32_t> next;   ///< memory of KeyCounts, of one phase at a time
  std::vector<BodyIndex> partner;
  PairTable merged;
  std::vector<std::uint32_t> entries;     ///< of cells (find_overlaps_in_strips), cell by cell: places in `boxes`
  std::vector<std::uint32_t> cell_start;  ///< by cell, in `entries`
};

/// A body in the solver of method layered; zeros for a body that does not move. The kernels read rows of doubles in
/// this order.
struct alignas(128) SolverBody {
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
  double inverse_mass = 0;
  double inverse_inertia[6] = {};  ///< world axes: xx, xy, xz, yy, yz, zz
  Vec3 lent = Vec3::Zero();  ///< kg^−½; a force F changes the velocity by F / mass − lent (lent · F) (lend_inertia)
};

/// Changes of velocity and spin of one body by one manifold, and two zeros: a row that the kernels write and add up.
struct alignas(64) Outcome {
  double of[8] = {};
};

/// The awake manifolds in batches, layer by layer; written by prepare_manifolds.
struct ContactBatches {
  LargeVector<ContactBatch> batches;
  std::vector<BatchSides> sides;  ///< by batch
  LargeVector<PointBatch> points;
  std::vector<ImpactBatch> impacts;                       ///< of the batches of which a manifold met fast
  std::vector<std::uint32_t> layer_start;                 ///< by layer, in `batches`
  std::vector<std::uint32_t> place;                       ///< by manifold: kLanes times batch plus lane
  std::vector<std::uint32_t> order;                       ///< the manifolds, batch by batch
  std::vector<BodyOutcomes> touched;                      ///< moving bodies in each layer, layer by layer
  std::vector<std::uint32_t> touched_start, touched_end;  ///< by layer, in `touched`
  std::vector<std::uint32_t> entries;                     ///< rows of `outcomes`, body by body
  std::vector<std::vector<std::uint32_t>> uses;           ///< by worker and body, while a layer is counted
  std::vector<std::uint32_t> counts;                      ///< by batch, points, while batches are filled
};

/// The layers of hard islands, or of the others. No moving body is in two groups. Written by assign_levels.
struct SweepGroup {
  std::uint32_t begin = 0, end = 0;  ///< layers
  int sweeps = 1;                    ///< at most; each island has its number (IslandScratch::sweeps)
  bool hard = false;                 ///< hard islands (assign_levels)
};

/// The awake contacts of each body, found again in every step (contact_graph.h).
struct ContactGraph {
  /// What the order of contacts needs to know of a manifold, in few bytes.
  struct Link {
    BodyIndex a = kGround, b = 0;  ///< as in the manifold
    std::uint32_t layer = 0;
    std::uint8_t count = 0;  ///< points
    bool awake = false;
    bool touches = false;   ///< has a point that touches
    std::int8_t upper = 0;  ///< which body the other one supports: 1: b, −1: a, 0: neither
  };
  std::vector<Link> links;           ///< by manifold
  std::vector<std::uint32_t> start;  ///< by body, in `ends`
  std::vector<std::uint32_t> ends;   ///< body by body, ascending: 2 · manifold + (1 where the body is b)
  std::vector<std::uint8_t> alone;   ///< by body: one worker has it and all that it touches; written by assign_levels
  unsigned alone_among = 0;          ///< so many workers, or 0: they have no homes
};

/// Values of in_contact. kFree: a body that does not move, or that flies; kInContact: one that the solver moves;
/// kBeyond: one that the solver has moved out of the grids, an error; kInFastPair: one with no contact but those of
/// fast pairs.
inline constexpr std::uint8_t kFree = 0, kInContact = 1, kBeyond = 2, kInFastPair = 3;

/// A body of a fast pair, as the step found it.
struct FastBody {
  BodyIndex row = 0;
  bool pressed = false;  ///< a contact of a fast pair pressed it in this step
  bool flying = false;   ///< the solver moves it, but no contact presses it in this substep
  bool waits = false;    ///< has met a body within this substep from which it bounces
  double parting = 0;    ///< m/s, the least speed at which it parts from what presses it; negative: it closes
  double flown_s = 0;    ///< of this substep, before its contacts are solved
  double work_most = 0;  ///< J, of its contacts as their push is ended
  std::int64_t given = 0, taken = 0;  ///< by them, in parts of work_most
  Vec3 position = Vec3::Zero(), velocity = Vec3::Zero(), spin = Vec3::Zero();
  Quat orientation;
};

/// How two bodies, or a body and the ground, come together within a time as long as nothing changes their free flights.
struct Approach {
  enum class Kind : std::uint8_t {
    kTouching,  ///< touch now
    kPassing,   ///< never touch, and stay farther apart than the margin
    kNear,      ///< never touch, but come within the margin
    kMeeting,   ///< touch later
  };
  Kind kind = Kind::kPassing;
  double time_s = 0;  ///< until a meeting
};

/// Contacts of fast pairs: corners of one of the two bodies leave the tangents of their paths within the step, so
/// contacts found at its start would hit what passes. They are found in every substep and make a layer of their own.
struct FastContacts {
  std::vector<ContactPair> pairs;      ///< ascending; written by find_manifolds
  std::vector<FastBody> bodies;        ///< ascending; listed by prepare_manifolds
  std::vector<std::uint32_t> place;    ///< by row, in `bodies`; only rows of `bodies` are written
  std::vector<Approach> approaches;    ///< of the pairs, in this substep; written by find_fast_contacts
  ManifoldList found;                  ///< in this substep, ascending; written by find_fast_contacts
  bool remembers = false;              ///< whether `memory` is of the last substep; if not, the state's is
  ContactMemory memory;                ///< written by bounce_fast_contacts and bounce_contacts
  ContactBatches batches;              ///< of one layer
  std::vector<std::uint32_t> members;  ///< of the layer
  std::vector<std::uint8_t> marked;    ///< by row: listed in `bodies`
  std::vector<std::uint8_t> waits;     ///< as `bodies`: those that bounce now
  bool takes_along = false;            ///< bodies that bounce touch others; written by bounce_fast_contacts
  std::vector<std::uint8_t> unmet;     ///< as `found.manifolds`: of bodies that wait and do not touch

  [[nodiscard]] bool none() const { return pairs.empty(); }
};

/// Copies of the columns that the trial phases write; a rejected substep puts them back.
struct SavedMotion {
  Vec3Column position, velocity, spin;
  QuatColumn orientation;
  PairTable pairs;
};

struct Scratch;

/// Observes the sweeps of method layered; they know nothing of the purpose. layer_solved() is called, by the thread
/// that steps, when the contacts of a layer have written their outcomes and before its bodies add the outcomes up.
/// `all` is scratch.contact_batches or the batches of fast pairs; the outcomes count from the first batch of the layer.
class LayerObserver {
 public:
  virtual ~LayerObserver() = default;
  virtual void layer_solved(const Scratch& scratch, const ContactBatches& all, std::size_t layer) = 0;
};

/// Of a body in collisions: whether one of them is no resting, and whether one has restitution 1. Sums of both.
inline constexpr std::uint8_t kHit = 1, kBouncesFully = 2;

/// Memory that the phases of a step pass on to each other. The future does not depend on it: an empty Scratch before
/// every step gives the bits of a kept one. It is kept only so that a warm step does not allocate and searches start
/// quickly.
struct Scratch {
  // Both methods: boxes and the search for pairs.
  std::vector<BoxFrame> frames;  ///< written by find_pairs and find_near_pairs
  Vec3Column aabb_low;           ///< likewise; on PositionGrid; method layered: also parting_velocity
  Vec3Column aabb_high;          ///< and parting_spin
  SweepScratch sweep;

  // Method thesis: what a phase passes on, in the order of the phases; then memory of single phases.
  std::vector<std::uint8_t> framed;       ///< bodies whose boxes are up to date; empty between steps
  std::vector<std::uint16_t> old_planes;  ///< by pair, before find_planes; written by find_pairs
  Contacts contacts;                      ///< written by find_planes (a, b, planes), find_contacts, compute_impulses
  std::vector<Gain> gains;                ///< by touched body, sum of its outcomes; written by compute_impulses
  std::vector<std::uint8_t> hit;          ///< by body, kHit and kBouncesFully; written by compute_impulses
  std::vector<std::uint8_t> touched;      ///< bodies in a real collision; written by compute_impulses
  Vec3Column displacement;                ///< by touched body, merged, m; written by compute_separation
  double removed_energy = 0;              ///< J, dissipated in this step; written by apply_outcomes
  SplitScratch split;
  SeparationScratch separation;
  FreezeScratch freezing;
  std::vector<SavedMotion> saved;  ///< by depth of halving; written by step

  // Method layered: what a phase passes on, in the order of the phases; then memory of single phases.
  std::vector<double> turning;             ///< m, way of corners by turning; written by find_near_pairs
  std::vector<VelocityRange> ranges;       ///< by body, empty where no two are fast; written by find_near_pairs
  std::vector<std::uint8_t> hit_unevenly;  ///< by body, empty as ranges; written by find_near_pairs
  std::vector<std::uint8_t> held;   ///< bodies that a contact pressed at the end of the last step; by find_manifolds
  LargeVector<Manifold> manifolds;  ///< in the order of the pairs; written by find_manifolds
  LargeVector<ManifoldPoint> manifold_points;
  std::vector<ManifoldList> manifolds_by;        ///< by worker, one or more
  std::vector<ManifoldPiece> manifold_pieces;    ///< in order of bodies, while several workers find manifolds
  std::vector<SharedBlocks::Range> blocks_left;  ///< of these pieces
  std::vector<std::uint32_t> pieces_start;       ///< by worker, in the next; one more at the end
  std::vector<std::uint32_t> pieces_by;          ///< these pieces, worker by worker
  std::vector<Homes::Range> manifold_ranges;     ///< who has found them, piece by piece
  FastContacts fast;
  bool found_again = false;  ///< whether wake_islands found the manifolds again
  ContactGraph graph;        ///< written by assign_levels
  std::vector<OwnList<std::pair<BodyIndex, std::uint32_t>>> sent_ends;  ///< memory of connect_contacts, by worker
  std::vector<std::uint32_t> ends_before;                               ///< likewise, by range of bodies
  std::vector<std::uint32_t> level;        ///< by body: contacts away from rest; written by assign_levels
  std::vector<std::uint32_t> layered;      ///< awake manifolds, layer by layer
  std::vector<std::uint32_t> layer_start;  ///< by layer, in `layered`
  std::vector<SweepGroup> sweep_groups;    ///< a group of hard islands comes last
  std::vector<double> solver_mass;         ///< kg, by body, along `lent_along` in the solver; written by carry_weights
  std::vector<Vec3> lent_along;            ///< by body, unit, where it has lent inertia; else zero
  std::vector<std::uint8_t> in_contact;    ///< by body, kFree … kInFastPair; written by prepare_manifolds
  std::vector<SolverBody> solver_bodies;   ///< written by prepare_manifolds and every sweep; last: ground
  ContactBatches contact_batches;
  std::vector<Outcome> outcomes;        ///< of one layer at a time, or of the contacts of fast pairs
  SweepShares shares;                   ///< written by prepare_manifolds
  VisitScratch visits;                  ///< written by prepare_manifolds and every sweep
  bool overlaps_part = false;           ///< any of them, in this step; written by part_overlaps
  std::vector<WaveScratch> waves;       ///< by worker; of assign_levels, then of carry_weights
  std::vector<BodyIndex> island_links;  ///< memory of Islands, of one phase at a time
  WakeScratch waking;
  IslandScratch islands;
  std::vector<std::uint32_t> next_in_layer;  ///< by slot and layer, while assign_levels sorts manifolds by layer
  WeightScratch weights;
  SleepScratch sleeping;

  // The loop of a step.
  std::uint32_t still_steps = 0;  ///< steps in a row without an input and without a body that could move
  std::vector<Energy> energies;   ///< by body, at the end of a step; with workers

  // The means of the caller, and who looks on. They change nothing but time.
  LaneWidth lanes = LaneWidth::kWidest;
  Workers* workers = nullptr;          ///< not owned
  Homes homes;                         ///< of bodies, among the workers; written by prepare_manifolds
  Homes manifold_homes;                ///< of manifolds: who has found them; written by find_manifolds
  LayerObserver* layers = nullptr;     ///< not owned; null: nobody looks
  Hasher* hasher = nullptr;            ///< of the observer, while a phase may feed it (hash_on_the_way.h)
  const Hasher* fed_hasher = nullptr;  ///< that the last phase has fed
};

/// What part_overlaps exchanges with solver_bodies while it solves, by row of these: speeds that end overlaps within
/// the step and then are forgotten, m/s and rad/s; update_sleeping reads them. Old where nothing parts. They lie in the
/// place of the AABBs, which find_near_pairs and nobody after it reads.
inline Vec3Column& parting_velocity(Scratch& scratch) { return scratch.aabb_low; }
inline Vec3Column& parting_spin(Scratch& scratch) { return scratch.aabb_high; }
inline const Vec3Column& parting_velocity(const Scratch& scratch) { return scratch.aabb_low; }
inline const Vec3Column& parting_spin(const Scratch& scratch) { return scratch.aabb_high; }

/// The points of a manifold.
inline std::span<ManifoldPoint> points_of(Scratch& scratch, const Manifold& m) {
  return std::span(scratch.manifold_points).subspan(m.first, m.count);
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
