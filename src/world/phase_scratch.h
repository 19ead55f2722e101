#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "src/base/large_vector.h"
#include "src/kernels/contacts/contact_batch.h"
#include "src/sharing/homes.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/manifold.h"
#include "tumble/sim/vec.h"
#include "tumble/sim/workers.h"
#include "tumble/sim/world_state.h"

/// Memory of single phases while they run; parts of Scratch, so that a warm step does not allocate. Another phase reads
/// none of it but what a comment says.
namespace tumble::sim {

/// The velocities that a body may get within a step, m/s, none (no motion) among them.
struct VelocityRange {
  Vec3 low = Vec3::Zero(), opposite_high = Vec3::Zero();  ///< no more than 0; minus the highest
};

/// A pair of bodies (lower row, higher row), or a body and kGround.
using ContactPair = std::pair<BodyIndex, BodyIndex>;

/// Manifolds and their points, as one worker finds them; in cache lines of its own, as OwnList.
struct alignas(128) ManifoldList {
  LargeVector<Manifold> manifolds;
  LargeVector<ManifoldPoint> points;
  std::vector<ContactPair> fast_pairs;  ///< ascending; see FastContacts

  /// Keeps the memory.
  void clear() {
    manifolds.clear();
    points.clear();
    fast_pairs.clear();
  }
};

/// A place in a contact memory: a contact, and its first point.
struct MemoryPlace {
  std::size_t contact = 0, point = 0;
};

/// Manifolds that belong together, in the list of the worker who has found them.
struct ManifoldPiece {
  struct Sizes {
    std::size_t manifolds = 0, points = 0, fast_pairs = 0;
  };
  Worker::Share bodies;
  MemoryPlace memory;   ///< where the impulses of these begin
  unsigned worker = 0;  ///< with whom the bodies are at home; then who has found the manifolds
  Sizes begin, end;     ///< of the list, before and after
};

inline std::span<ManifoldPoint> points_of(ManifoldList& list, const Manifold& m) {
  return std::span(list.points).subspan(m.first, m.count);
}
inline std::span<const ManifoldPoint> points_of(const ManifoldList& list, const Manifold& m) {
  return std::span(list.points).subspan(m.first, m.count);
}

/// What one contact asks of a body: to move out of the other body.
struct Displacement {
  Vec3 direction;       ///< unit length
  double distance = 0;  ///< m, >= 0
  bool shared = false;  ///< whether the other body gives way too
};

/// Memory of compute_separation.
struct SeparationScratch {
  std::vector<std::uint32_t> start;  ///< by body, in `wanted`; one more at the end
  std::vector<Displacement> wanted;  ///< body by body
};

/// The outcome of a collision for one of its bodies, zeros for a body that does not move; or the sum of a body's
/// outcomes.
struct Gain {
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();  ///< m/s, rad/s, on VelocityGrid
  Vec3 way_back = Vec3::Zero();                       ///< m, on PositionGrid
  double largest = 0;  ///< the largest part of velocity and spin, m/s or rad/s; of a sum, the sum of those
};

struct PairMaterial {
  double friction = 0, friction_dynamic = 0, restitution = 0;
  double slip_speed = 0;  ///< m/s
};

/// An impulse's angular impulses about the centres of two bodies, N·m·s, axes of each body.
struct Turns {
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();
};

/// How two bodies move at their collision point before all collisions, whatever parts of their masses collide.
/// Rows that a kernel reads as doubles, also where a machine would align these to four bytes.
struct alignas(sizeof(double)) Encounter {
  Vec3 relative = Vec3::Zero();  ///< m/s, of b's point
  Vec3 tangent = Vec3::Zero();   ///< unit, along the slip; zero without slip
  Turns by_normal, by_tangent;   ///< of unit impulses
  double approach = 0;           ///< m/s along the normal; the bodies part where it is not negative
  double slip = 0;               ///< m/s along the tangent, >= 0
  double pull = 0;               ///< m/s of slip that gravity adds in one substep
  bool rough = false;            ///< whether there is friction
  bool slow = false;             ///< whether the slip was slow before gravity acted, or turned round
  bool shared = false;           ///< whether the corners may share the load
};

/// Memory of compute_impulses (split_mass.h).
struct SplitScratch {
  std::vector<Encounter> encounters;    ///< by contact
  std::vector<PairMaterial> materials;  ///< by contact
  std::vector<std::uint8_t> met;        ///< by contact, whether all of the encounter is known, not the approach alone
  std::vector<std::uint8_t> resting;    ///< by contact with the ground, as in Collision, where a kernel found it
  std::vector<Gain> gains;              ///< by contact, of a and of b
  std::vector<std::uint32_t> again;     ///< contacts that this round computes
  std::vector<double> parts;            ///< by body, >= 1: its mass is divided by this
  std::vector<std::uint8_t> raised;     ///< by body, whether the last round raised the number of parts
  std::vector<std::uint8_t> changed;    ///< by body, whether this round computes one of its collisions
  std::vector<std::uint32_t> contacts;  ///< by body
  std::vector<BodyIndex> several;       ///< bodies with several contacts, in any order
  std::vector<std::uint32_t> count;     ///< by body that changed, collisions with an impulse
  std::vector<double> together;         ///< by body that changed, J, twice: of the sum of its gains
  std::vector<double> magic;            ///< by body that changed, of the grid of `sum`
  std::vector<double> sum;              ///< by body that changed, J, twice: of its gains one by one
  std::vector<double> energy;           ///< by contact, of a's gain and of b's, J, twice; 0 for what does not move and
                                        ///< for a body with one contact
};

/// A body that may freeze in this substep, and the height of the lowest object that it touches.
struct FreezeCandidate {
  bool ready = false;
  double lowest = 0;  ///< height of the object's centre over the body's, times gravity; −infinity: ground
};

/// Memory of update_freezing.
struct FreezeScratch {
  std::vector<BodyIndex> ready;             ///< to freeze
  std::vector<FreezeCandidate> candidates;  ///< of each body, where any is ready
  std::vector<std::uint8_t> frozen_before;
  std::vector<std::pair<BodyIndex, BodyIndex>> carriers;  ///< a body and an object that carries it
  ContactObjects found;
  ContactObjects merged;
};

/// Memory of wake_islands.
struct WakeScratch {
  std::vector<BodyIndex> disturbed;  ///< sleepers that a lively body is about to touch
  std::vector<BodyIndex> woken;      ///< while find_manifolds, which reads them, runs again: all that woke; else empty
  std::vector<std::uint8_t> wakes;   ///< by the body that stands for an island
};

/// Bodies in waves, as one worker pushes and treats them (waves.h).
struct alignas(128) WaveScratch {
  std::vector<BodyIndex> pushed[2];  ///< to waves of even and of odd numbers
  std::vector<BodyIndex> sent[2];    ///< likewise, of bodies at home with other workers
  std::vector<BodyIndex> taken;      ///< those that it treats, wave by wave
  std::vector<std::uint32_t> start;  ///< by wave, in `taken`; one more at the end
};

/// Values of IslandScratch::hits. kHitAlone: a contact of the island is hit fast enough to bounce; kSharedHit: one
/// whose layer has others that share the mass of its bodies.
inline constexpr std::uint8_t kNotHit = 0, kHitAlone = 1, kSharedHit = 2;

/// The islands of a step. assign_levels writes them; carry_weights `reach2` and `heaviest`.
struct IslandScratch {
  std::vector<BodyIndex> of, hit;                  ///< by body, the one that stands for its island; for those of hits
  std::vector<std::uint8_t> hard;                  ///< by body, whether its island is hard
  std::vector<std::uint8_t> sweeps;                ///< by body, of its contacts in push_contacts and relax_contacts
  std::vector<std::uint8_t> turns;                 ///< by body, of its contacts in bounces
  std::vector<std::uint8_t> marked;                ///< by the body that stands for an island
  std::vector<std::uint8_t> most_sweeps, has_bar;  ///< by the body that stands for an island of hits; of its bodies
  std::vector<std::uint32_t> layers;               ///< likewise, how many
  std::vector<std::uint8_t> fast;                  ///< by body, whether it may hit another one hard
  std::vector<std::uint8_t> hits;                  ///< by the body that stands for an island of hits, kNotHit …
  std::vector<double> reach2, heaviest;  ///< by the body that stands for an island, m², kg; of corners and masses
};

/// Memory of carry_weights.
struct WeightScratch {
  /// A manifold through which one body rests on another.
  struct Support {
    double load = 0;  ///< kg
    std::uint32_t manifold = 0;
    BodyIndex upper = 0, lower = 0;
    std::uint32_t first_point = 0, end_point = 0;  ///< in `points`, while the upper body is treated
    bool bears = false;                            ///< has a point that touches and does not part
    bool starts = false;                           ///< is new and rests, so it wants first impulses
  };
  /// A contact point that bears weight.
  struct SupportPoint {
    ManifoldPoint* point = nullptr;
    double x = 0, y = 0;  ///< m, horizontal place from the upper body's centre
    double load = 0;      ///< kg, before scaling to the weight
  };
  /// Where a body is hit from above, along gravity.
  struct Blow {
    double x = 0, y = 0;     ///< m, horizontal place from the body's centre
    std::uint32_t next = 0;  ///< in `blows`, of the same body; kNoBlow after the last
  };
  static constexpr std::uint32_t kNoBlow = 0xffffffffU;
  std::vector<Support> supports;              ///< by upper body
  std::vector<std::uint32_t> start;           ///< by body, in `supports`
  std::vector<OwnList<SupportPoint>> points;  ///< by worker: under one body at a time
  std::vector<std::uint32_t> waiting_for;     ///< by body: supports above that have not passed on their weight
  std::vector<std::uint8_t> meets;            ///< by manifold: one of its points approaches fast
  std::vector<std::uint32_t> meeting;         ///< by worker: number of such manifolds
  std::vector<Blow> blows;
  std::vector<std::uint32_t> first_blow;  ///< by body, in `blows`
  std::vector<std::uint8_t> struck;       ///< by body: hit from below or from the side
  std::vector<std::uint8_t> stands;       ///< by body: its weight, all that it bears and blows press between its points
  std::vector<std::uint8_t> held;  ///< by body: stands, on ground or on bodies that are held; update_sleeping reads it
  std::vector<std::uint8_t> settled;       ///< by body: is held, and so is all that bears weight above
  std::vector<double> offered;             ///< kg, by body, the largest mass above
  std::vector<double> borne;               ///< kg, by body, everything that rests on the body
  std::vector<double> moment_x, moment_y;  ///< kg·m about the body's centre, of everything that rests on it
};

/// Which bodies the sweeps of a step have moved; ContactWork::visit.
struct VisitScratch {
  std::vector<std::uint32_t> moved;  ///< by row of solver_bodies: number of the last visit that moved the body
  std::uint32_t now = 0, first = 0;  ///< number of the last visit, and of the last one before the present sweeps
  std::uint32_t bounces = 0;         ///< number of the last visit before the bounces of the last substep
  double still = 0;                  ///< m/s or rad/s; smaller changes do not make a contact due again

  struct Reach {
    std::uint32_t begin = 0, end = 0;  ///< layers
  };
  std::vector<Reach> reach_of_body;  ///< by row; layers of the body's contacts
  std::vector<Reach> reach;  ///< by layer; layers that share moving bodies with it; written by prepare_manifolds

  struct Layer {
    std::uint32_t looked = 0;   ///< number of the last visit of the present sweeps; 0: none
    std::uint32_t stirred = 0;  ///< number of the last visit that may have moved one of the layer's bodies
  };
  std::vector<std::vector<Layer>> layers;  ///< by worker and layer; all workers note alike
};

/// Which worker solves which batches in the sweeps of a step (cut_layers.h, share_sweeps.h). A piece is what a worker
/// has of a layer; pieces are numbered layer by layer, worker by worker.
struct SweepShares {
  unsigned parts = 1;                 ///< workers; with 1 the rest is old
  std::vector<std::uint32_t> order;   ///< batches, piece by piece; those with bodies of several workers first
  std::vector<std::uint32_t> first;   ///< by piece, in `order`; one more at the end
  std::vector<std::uint64_t> users;   ///< by body: a bit for each worker whose batches have contacts of it
  std::vector<std::uint64_t> heirs;   ///< by piece: a bit for each other worker who adds up outcomes of the piece
  std::vector<std::uint32_t> urgent;  ///< by piece: batches whose outcomes other workers wait for
  std::uint32_t rows = 0;             ///< of solver_bodies, before those of copies
  std::vector<std::uint32_t> copies;  ///< by copy: its body. The first user of a body has the body's own row
  std::vector<std::uint32_t> copies_before;  ///< by body
  std::vector<BodyOutcomes> touched;         ///< piece by piece: bodies of the layer that the worker uses
  std::vector<std::uint32_t> touched_first;  ///< by piece, in `touched`; one more at the end
  std::vector<std::uint32_t> counts;         ///< by worker, copies before its range of bodies
  int axis = 0;                              ///< across which the layers are cut
  std::vector<double> cuts;                  ///< m, twice the places between the workers' shares of the largest layer
  std::vector<OwnList<std::pair<double, std::uint32_t>>> places;  ///< by worker: where the batches of a layer are

  [[nodiscard]] std::span<const std::uint32_t> batches_of(std::size_t layer, unsigned worker) const {
    return piece(order, first, layer * parts + worker);
  }
  [[nodiscard]] std::span<const BodyOutcomes> touched_of(std::size_t layer, unsigned worker) const {
    return piece(touched, touched_first, layer * parts + worker);
  }

 private:
  template <class Item>
  static std::span<const Item> piece(const std::vector<Item>& items, const std::vector<std::uint32_t>& begin,
                                     std::size_t k) {
    return std::span(items).subspan(begin[k], begin[k + 1] - begin[k]);
  }
};

/// Memory of update_sleeping.
struct SleepScratch {
  std::vector<std::uint8_t> touching;  ///< bodies that touch anything
  std::vector<std::uint8_t> restless;  ///< by the body that stands for an island
  std::vector<std::uint8_t> held;      ///< likewise: the island touches what does not move
  std::vector<std::uint8_t> together;  ///< likewise: the island has two bodies or more
  std::vector<double> energy_before;   ///< J/kg, as prepare_manifolds found a body; of those that may sleep afterwards
};

}  // namespace tumble::sim
