#include "src/layered/solve/find_fast_contacts.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "src/kernels/kernels_by_width.h"
#include "src/layered/batch/batch_contacts.h"
#include "src/layered/find/build_manifolds.h"
#include "src/layered/find/fast_pairs.h"
#include "src/layered/find/join_lists.h"
#include "src/layered/order/solver_body.h"
#include "src/layered/solve/contact_batches.h"
#include "src/layered/solve/fast_bodies.h"
#include "src/layered/solve/solver_hashes.h"
#include "src/math/grid.h"
#include "src/world/free_flight.h"
#include "src/world/hash_on_the_way.h"

namespace tumble::sim {
namespace {

constexpr double kMet = 0.0002;  // m; free flights are followed to half of that

// Gives a body's columns and its frame the motion and the place of now.
void renew_body(WorldState& state, Scratch& scratch, BodyIndex i, double substep_s) {
  Bodies& bodies = state.bodies;
  const SolverBody& now = scratch.solver_bodies[i];
  bodies.velocity.set(i, plus_zero(now.velocity));
  bodies.spin.set(i, plus_zero(now.spin));
  BoxFrame& frame = scratch.frames[i];
  frame.position = bodies.position[i];
  frame.axes = axes_of(bodies.orientation[i]);
  scratch.turning[i] = length(now.spin) * length(frame.half_extent) * substep_s;
}

// Gives all bodies the motion and the place of now, by several workers at a time.
void renew_bodies(WorldState& state, Scratch& scratch, double substep_s) {
  for_fast_bodies(scratch, [&](const FastBody& body) {
    if (scratch.in_contact[body.row] != 0) renew_body(state, scratch, body.row, substep_s);
  });
}

// Finds for each body the time of its first meeting, s; 0 for a body that touches another one of a fast pair.
void find_meetings(Scratch& scratch, double substep_s) {
  FastContacts& fast = scratch.fast;
  const auto meets = [&](BodyIndex i, double time_s) {
    if (i != kGround) shared::lower(fast.bodies[fast.place[i]].flown_s, time_s);
  };
  const unsigned parts = part_count(scratch.workers, fast.pairs.size(), kFastAPart);
  work_together(scratch.workers, parts, [&](const Worker& worker) {
    const Worker::Share bodies = worker.share(fast.bodies.size()), pairs = worker.share(fast.pairs.size());
    for (std::size_t k = bodies.begin; k < bodies.end; ++k) fast.bodies[k].flown_s = substep_s;
    worker.meet();
    for (std::size_t k = pairs.begin; k < pairs.end; ++k) {
      const Approach& approach = fast.approaches[k];
      if (approach.kind != Approach::Kind::kMeeting && approach.kind != Approach::Kind::kTouching) continue;
      meets(fast.pairs[k].first, approach.time_s);
      meets(fast.pairs[k].second, approach.time_s);
    }
    worker.meet();
    for (std::size_t k = bodies.begin; k < bodies.end; ++k) {
      FastBody& body = fast.bodies[k];
      const bool free = scratch.in_contact[body.row] == kInFastPair && body.flown_s < substep_s;
      if (!free) body.flown_s = 0;
    }
  });
}

// Moves a body in free flight to its first meeting.
void fly(WorldState& state, Scratch& scratch, const FastBody& body) {
  Bodies& bodies = state.bodies;
  const BodyIndex i = body.row;
  SolverBody& now = scratch.solver_bodies[i];
  const Vec3 fall = state.def.gravity * body.flown_s;
  bodies.position.set(
      i, plus_zero(bodies.position[i] + PositionGrid::round_any(Vec3((now.velocity + fall * 0.5) * body.flown_s))));
  now.velocity += VelocityGrid::round(fall);
  const Vec3 inverse = bodies.inverse_inertia[i];
  const Rotation turn = rotate_freely(bodies.orientation[i], now.spin, bodies.inertia[i], inverse, body.flown_s);
  bodies.orientation.set(i, turn.orientation);
  now.spin = turn.spin;
  set_inverse_inertia(now, axes_of(turn.orientation), inverse);
}

// The points of one manifold of a batch.
class PointsOfLane {
 public:
  PointsOfLane(ContactBatches& all, ContactBatch& batch, unsigned lane)
      : points_(std::span(all.points).subspan(batch.first, batch.count)),
        friction_{&batch.force1, &batch.force2, &batch.twist},
        lane_(lane),
        acceleration_(batch.acceleration.of[lane]) {}

  // In a bounce leaves out all points but those that meet fast now: the bodies wait, and others meet in a later
  // substep, if they still do. Where no point bounces now, those that meet fast later in the substep bounce at once,
  // where they are. One that meets later still is left out too, since a push that stops it in part would be no bounce.
  // What is left out and does not touch presses with nothing, also where it did in the substep before.
  void separate_bounce(double substep_s) {
    const auto touches = [&](const PointBatch& point) { return point.separation.of[lane_] <= kMet; };
    const auto meets = [&](const PointBatch& point) {
      const double separation = point.separation.of[lane_], approach = point.approach.of[lane_];
      return separation + 0.5 * (approach + speed_now(point)) * substep_s < 0;
    };
    const bool now = std::ranges::any_of(points_, [&](const PointBatch& p) { return fast(p) && touches(p); });
    const bool later = !now && std::ranges::any_of(points_, [&](const PointBatch& p) { return fast(p) && meets(p); });
    for (PointBatch& point : points_) {
      if (fast(point) && (touches(point) || (later && meets(point)))) {
        meet_here(point);
      } else if (now || later || fast(point)) {
        point.mass.of[lane_] = 0;
        if (!touches(point)) press_no_more(point);
      }
    }
  }

 private:
  bool fast(const PointBatch& point) const { return point.approach.of[lane_] <= -kFastBounceMin; }

  // m/s, without what foresee_impact has added for a meeting after a fall.
  double speed_now(const PointBatch& point) const {
    const double separation = point.separation.of[lane_], approach = point.approach.of[lane_];
    if (separation <= 0 || approach >= 0) return approach;
    return -std::sqrt(std::max(0.0, approach * approach + 2 * acceleration_ * separation));
  }

  // Friction begins anew then: a part of it was due to this impulse.
  void press_no_more(PointBatch& point) const {
    if (point.impulse.of[lane_] == 0) return;
    point.impulse.of[lane_] = 0;
    for (Lanes* const friction : friction_) friction->of[lane_] = 0;
  }

  void meet_here(PointBatch& point) const {
    if (point.separation.of[lane_] <= 0) return;
    point.approach.of[lane_] = speed_now(point);
    point.separation.of[lane_] = 0;
  }

  std::span<PointBatch> points_;
  Lanes* friction_[3];
  unsigned lane_;
  double acceleration_;
};

// Pieces of the pairs that each of several workers has in the mean; for each, one looks up where the impulses begin.
constexpr std::size_t kFastPiecesAPart = 4;

// Several workers find pieces of the pairs, each into a list of its own.
void find_manifolds_of(const WorldState& state, Scratch& scratch, double substep_s) {
  FastContacts& fast = scratch.fast;
  const std::size_t n = fast.pairs.size();
  const unsigned parts = part_count(scratch.workers, n, kFastAPart);
  std::vector<ManifoldList>& lists = scratch.manifolds_by;  // find_manifolds is done with them
  std::vector<ManifoldPiece>& pieces = scratch.manifold_pieces;
  if (lists.size() < parts) lists.resize(parts);
  const std::size_t count = parts == 1 ? 1 : kFastPiecesAPart * parts;
  pieces.assign(count, {});
  const ContactMemory& memory = fast.remembers ? fast.memory : state.contact_memory;
  work_together(scratch.workers, parts, [&](const Worker& worker) {
    ManifoldList& list = parts == 1 ? fast.found : lists[worker.part];
    list.clear();
    SharedBlocks(scratch.blocks_left, worker.share(count), worker).take_all([&](std::size_t k) {
      const std::size_t begin = n * k / count, here = n * (k + 1) / count - begin;
      pieces[k].worker = worker.part;
      pieces[k].begin = {list.manifolds.size(), list.points.size(), 0};
      const FastRange range = {std::span(fast.pairs).subspan(begin, here),
                               std::span(fast.approaches).subspan(begin, here), memory};
      if (here > 0) build_fast_manifolds(state, scratch, substep_s, range, list);
      pieces[k].end = {list.manifolds.size(), list.points.size(), 0};
    });
  });
  if (parts > 1) {
    join_lists(pieces, std::span(lists).first(parts), scratch.workers, fast.found.manifolds, fast.found.points);
    make_room(std::span(lists).first(parts), fast.found.manifolds.size(), fast.found.points.size());
  }
}

void separate_bounces(ContactBatches& all, std::size_t begin, std::size_t end, double substep_s) {
  for (std::size_t k = begin; k < end; ++k) {
    ContactBatch& batch = all.batches[k];
    for (unsigned lane = 0; lane < batch.used; ++lane) {
      if (batch.restitution.of[lane] > 0) PointsOfLane(all, batch, lane).separate_bounce(substep_s);
    }
  }
}

// Whether a point touches; and whether one of those meets fast enough to bounce, where the materials bounce.
struct Touching {
  bool any = false, bounces = false;
};
Touching touching_points(const Bodies& bodies, const ManifoldList& found, const Manifold& m) {
  const Vec3 none = Vec3::Zero();
  const Vec3 va = m.a == kGround ? none : bodies.velocity[m.a], wa = m.a == kGround ? none : bodies.spin[m.a];
  const Vec3 u = (bodies.velocity[m.b] - va) - cross(wa, m.d), w = bodies.spin[m.b] - wa;
  const double un = dot(u, m.n), w1 = dot(w, m.t1), w2 = dot(w, m.t2);
  Touching touching;
  for (const ManifoldPoint& point : points_of(found, m)) {
    const double speed = un + (w1 * point.q - w2 * point.p);
    if (point.separation > kMet || speed >= kFastBounceMin) continue;
    touching.any = true;
    touching.bounces |= speed <= -kFastBounceMin;
  }
  return touching;
}

// Leaves out the contacts of bodies that bounce now with those that they do not touch: the bodies wait, and meet others
// in a later substep, if they still do. Such a contact would take its part of the body's mass in the bounce.
void leave_unmet(const Bodies& bodies, Workers* workers, FastContacts& fast) {
  ManifoldList& found = fast.found;
  std::vector<std::uint8_t>& waits = fast.waits;
  waits.assign(fast.bodies.size(), 0);
  std::uint8_t any = 0;
  for_ranges(workers, found.manifolds.size(), kFastAPart, [&](std::size_t begin, std::size_t end) {
    for (const Manifold& m : std::span(found.manifolds).subspan(begin, end - begin)) {
      if (m.restitution == 0 || !touching_points(bodies, found, m).bounces) continue;
      mark(any);
      mark(waits[fast.place[m.b]]);
      if (m.a != kGround) mark(waits[fast.place[m.a]]);
    }
  });
  if (any == 0) return;
  const auto waiting = [&](BodyIndex i) { return i == kGround || !bodies.moves(i) || waits[fast.place[i]] != 0; };
  fast.unmet.resize(found.manifolds.size());
  std::size_t kept = found.manifolds.size();
  for_ranges(workers, found.manifolds.size(), kFastAPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Manifold& m = found.manifolds[k];
      const bool unmet = waiting(m.a) && waiting(m.b) && !touching_points(bodies, found, m).any;
      fast.unmet[k] = unmet ? 1 : 0;
      if (unmet) shared::lower(kept, k);
    }
  });
  if (kept == found.manifolds.size()) return;
  std::uint32_t points = found.manifolds[kept].first;
  for (std::size_t k = kept; k < found.manifolds.size(); ++k) {
    if (fast.unmet[k] != 0) continue;
    const Manifold& m = found.manifolds[k];
    const auto begin = found.points.begin() + m.first;
    std::copy(begin, begin + m.count, found.points.begin() + points);
    found.manifolds[kept] = m;
    found.manifolds[kept].first = std::exchange(points, points + m.count);
    ++kept;
  }
  found.manifolds.resize(kept);
  found.points.resize(points);
}

}  // namespace

Status find_fast_contacts(WorldState& state, Scratch& scratch, double substep_s) {
  if (scratch.fast.none()) return {};
  FastContacts& fast = scratch.fast;
  renew_bodies(state, scratch, substep_s);
  find_approaches(state, scratch, substep_s, fast.approaches);
  find_meetings(scratch, substep_s);
  for_fast_bodies(scratch, [&](const FastBody& body) {
    if (body.flown_s > 0) fly(state, scratch, body);
  });
  renew_bodies(state, scratch, substep_s);
  find_manifolds_of(state, scratch, substep_s);
  leave_unmet(state.bodies, scratch.workers, fast);
  batch_fast_contacts(state, scratch);
  std::uint8_t any_met = 0;
  for_fast_batches(scratch, substep_s, [&](const ContactWork& part, std::size_t begin, std::size_t end) {
    kernels(scratch.lanes).contacts.prepare(part);
    if (mark_bounces(part)) mark(any_met);
    separate_bounces(fast.batches, begin, end, substep_s);
  });
  list_impacts(fast.batches, any_met != 0);
  return {};
}

void hash_find_fast_contacts(const WorldState& state, const Scratch& scratch, Hasher& hasher) {
  if (scratch.fast.none()) return;
  {
    const Bodies& bodies = state.bodies;
    GatheredNumbers numbers(&hasher);
    for (const FastBody& body : scratch.fast.bodies) {
      for (const Vec3& v : {bodies.position[body.row], bodies.velocity[body.row], bodies.spin[body.row]})
        numbers.add(v);
      numbers.add(bodies.orientation[body.row]);
      for (const double value : scratch.solver_bodies[body.row].inverse_inertia) *numbers.next(1) = value;
    }
  }
  add_fast_batches(scratch, hasher);
}

}  // namespace tumble::sim
