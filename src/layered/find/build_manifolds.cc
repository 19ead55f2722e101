#include "src/layered/find/build_manifolds.h"

#include <algorithm>

#include "src/layered/find/contact_axes.h"
#include "src/layered/find/contact_memory.h"
#include "src/layered/find/contact_recall.h"
#include "src/layered/find/fast_pairs.h"
#include "src/layered/find/find_near_pairs.h"
#include "src/layered/find/free_path.h"
#include "src/layered/find/manifold_materials.h"
#include "src/layered/find/manifold_points.h"
#include "src/layered/find/pair_tests.h"
#include "src/layered/find/point_reach.h"
#include "src/layered/find/velocity_ranges.h"
#include "src/world/manifold_hashes.h"

namespace tumble::sim {
namespace {

// Builds the manifolds of one pair after the other.
class Builder {
 public:
  // memory: the impulses to recall, from that place on.
  Builder(const WorldState& state, const Scratch& scratch, double dt_s, const ContactMemory& memory,
          const MemoryPlace& from, ManifoldList& out)
      : state_(state),
        bodies_(state.bodies),
        scratch_(scratch),
        out_(out),
        dt_(dt_s),
        substep_(state.def.dt / state.def.substeps),
        fall_(falling_reach(state.def, dt_s)),
        sag_(falling_reach(state.def, substep_)),
        pushing_s_(dt_s + substep_),
        paths_(state, scratch, dt_s),
        ahead_(state, scratch, pushing_s_),
        recall_(memory, from) {}

  // Builds the manifolds of the bodies [first, end), each with bodies of higher rows and with the ground, and lists
  // fast pairs instead.
  void build(BodyIndex first, BodyIndex end, Hasher* hasher) {
    const PairTable& pairs = state_.pairs;
    std::size_t k = pairs_before(pairs, first);
    PairTests tests(state_, scratch_, dt_, k, pairs_before(pairs, end));
    const std::size_t most = manifolds_max(bodies_.size());
    ManifoldFeed feed(hasher);
    for (BodyIndex i = first; i < end && out_.manifolds.size() <= most; ++i) {
      feed.add_whole_blocks(out_);
      for (; k < pairs.size() && pairs.a[k] == i; ++k) {
        const BodyIndex j = pairs.b[k];
        if (!bodies_.moves(i) && !bodies_.moves(j)) {
          recall_.keep(i, j, out_);
        } else if (pair_ = tests.next(); pair_ != nullptr && !pair_->in_reach) {
          list_if_hit(i, j);
        } else if (pair_ != nullptr && !listed_as_fast(i, j)) {
          step_pair(i, j);
        }
      }
      if (!state_.def.ground || bodies_.is_static[i] != 0) continue;
      if (!bodies_.moves(i)) {
        recall_.keep(i, kGround, out_);
      } else if (reaches(i, fall_) && !listed_as_fast(i, kGround)) {
        if (!reaches(i, fall_of(i))) out_.fast_pairs.emplace_back(i, kGround);
        ground(i);
      }
    }
    feed.add_rest(out_);
  }

  // Builds the manifolds of those of the pairs that come together in the substep.
  void build_fast(std::span<const ContactPair> pairs, std::span<const Approach> approaches) {
    in_substep_ = true;
    FastPairTests tests(scratch_, pairs, approaches);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto [i, j] = pairs[k];
      if (approaches[k].kind == Approach::Kind::kPassing) continue;
      if (j == kGround) {
        ground(i);
        continue;
      }
      pair_ = &tests.next();
      const std::size_t manifolds = out_.manifolds.size(), points = out_.points.size();
      pushes_ = false;
      if (!pair(i, j) && approaches[k].kind == Approach::Kind::kMeeting) add_last(i, j);
      if (pushes_ && approaches[k].kind == Approach::Kind::kNear && passes(scratch_, ahead_, i, j))
        leave(manifolds, points);
    }
  }

 private:
  double turning(BodyIndex i) const { return scratch_.turning[i]; }
  // Whether corners leave their tangents by more than contacts allow, or the pair may meet fast. hi may be kGround.
  bool listed_as_fast(BodyIndex lo, BodyIndex hi) {
    if (!meets_fast(state_, scratch_, lo, hi, dt_) && !must_be_followed(scratch_, paths_, lo, hi)) return false;
    out_.fast_pairs.emplace_back(lo, hi);
    return true;
  }

  // pair_ is the result of the box test. Returns whether the pair needs nothing else: it has a manifold, or does not
  // meet.
  bool pair(BodyIndex lo, BodyIndex hi) {
    lo_ = lo, hi_ = hi;
    smallest_ = smallest_half_extent(scratch_.frames[lo], scratch_.frames[hi]);
    approach_ = bodies_.velocity[hi] - bodies_.velocity[lo];
    turn_ = turning(lo) + turning(hi);
    const std::size_t before = out_.manifolds.size();
    const double slop = std::min(kSlop, kSlopOfHalfExtent * smallest_);
    const double sliding = sliding_overlap(slop, length(approach_) * substep_), most = slack_of(smallest_);
    open_ = {std::min(slop + sag_, most), std::min((holds_one(scratch_, lo, hi) ? sliding : slop) + sag_, most)};
    const double apart = separation_of(*pair_), closes = length(approach_) * (dt_ - pair_->later) + turn_;
    const bool near = apart >= -open_.most && apart - closes <= slack_of(smallest_) + fall_of(smallest_);
    const bool passing = near && leave_pushing_axes(lo, hi);
    add_preferred(lo, hi);
    return passing || out_.manifolds.size() > before;
  }

  // Leaves of the axes those that may push. Returns whether the pair passes. Edges that pressed in the last step, as in
  // the ridge of two boards that lean on each other, press on though both faces beside them are open.
  bool leave_pushing_axes(BodyIndex lo, BodyIndex hi) {
    const BoxFrame &a = scratch_.frames[lo], &b = scratch_.frames[hi];
    if (!may_open_two(a, b, *pair_, open_.most)) return false;
    const Vec3 way = approach_ * (dt_ - pair_->later);
    TestedPair left = *pair_;
    const bool passing = leave_pushing(a, b, {way, bodies_.spin[lo] * dt_, bodies_.spin[hi] * dt_}, open_, left);
    if (!left.any_axis() && recall_.pressed(lo, hi)) return false;
    tested_ = left;
    pair_ = &tested_;
    return passing;
  }

  // Adds what a pair needs in the step: manifolds, or a place among the fast pairs.
  void step_pair(BodyIndex lo, BodyIndex hi) {
    const std::size_t manifolds = out_.manifolds.size(), points = out_.points.size();
    pushes_ = false;
    if (!pair(lo, hi)) return list_if_meeting(lo, hi);
    const bool moves = turn_ > 0 || approach_ != Vec3::Zero();  // part_overlaps moves bodies at rest too
    if (!moves || !pushes_ || !passes(scratch_, ahead_, lo, hi)) return;
    leave(manifolds, points);
    out_.fast_pairs.emplace_back(lo, hi);
  }
  void leave(std::size_t manifolds, std::size_t points) {
    out_.manifolds.resize(manifolds);
    out_.points.resize(points);
  }

  // A pair that meets although no point closes or lies in both boxes, as it faces now, gets its contacts when it meets.
  void list_if_meeting(BodyIndex lo, BodyIndex hi) {
    if (pair_->later == 0 && separation_of(*pair_) > length(approach_) * dt_ + turn_) return list_if_hit(lo, hi);
    if (paths_.follow(lo, hi, 0).kind != Approach::Kind::kMeeting) return list_if_hit(lo, hi);
    out_.fast_pairs.emplace_back(lo, hi);
  }
  void list_if_hit(BodyIndex lo, BodyIndex hi) {
    if (may_meet_if_hit(scratch_, lo, hi, fall_, dt_)) out_.fast_pairs.emplace_back(lo, hi);
  }

  // The axes that kept two boxes apart until they met; edges like faces only if nothing else touches.
  void add_last(BodyIndex lo, BodyIndex hi) {
    const BoxPair boxes(scratch_.frames[lo], scratch_.frames[hi]);
    const std::size_t before = out_.manifolds.size();
    add_axes(lo, hi, boxes.best(kFaces | kEdges));
    if (out_.manifolds.size() == before) add_axes(lo, hi, last_axes(boxes));
  }
  void add_axes(BodyIndex lo, BodyIndex hi, const BestAxes& best) {
    add_faces(lo, hi, static_cast<AxisSet>(best.axes & kFacesOfA));
    add_faces(hi, lo, static_cast<AxisSet>((best.axes & kFacesOfB) >> 3U));
    add_edges(lo, hi, {static_cast<AxisSet>(best.axes & kEdges), best.separation});
  }

  void add_preferred(BodyIndex lo, BodyIndex hi) {
    const int order = reference_order(scratch_.frames[lo], scratch_.frames[hi], pair_->offset);
    const ContactAxes axes = preferred_axes(*pair_, order, smallest_);
    add_edges(lo, hi, axes.edges);
    add_faces(lo, hi, axes.faces_of_a);
    add_faces(hi, lo, axes.faces_of_b);
  }

  // The separation, m, up to which points are kept. n: from the lower row to the higher.
  double margin_of(const Vec3& n) const {
    return closing_along(n) + (turn_ + fall_of(smallest_)) + slack_of(smallest_);
  }

  // How much nearer the two may come along n, m: in a substep also if a third body stops or hits one of them.
  double closing_along(const Vec3& n) const {
    const double alone = std::max(0.0, -dot(approach_, n)) * dt_;
    return in_substep_ ? std::max(alone, way_if_hit(scratch_, lo_, hi_, n, dt_)) : alone;
  }

  // axes: faces of the reference, from bit 0 on.
  void add_faces(BodyIndex reference, BodyIndex incident, AxisSet axes) {
    const Vec3& offset = pair_->offset;
    for_each_axis(axes, [&](int axis) {
      add_face(reference, incident, axis, margin_of(towards(offset, scratch_.frames[reference].axes[axis])));
    });
  }

  void add_edges(BodyIndex lo, BodyIndex hi, const BestAxes& edge) {
    const int order = reference_order(scratch_.frames[lo], scratch_.frames[hi], pair_->offset);
    for_each_axis(edge.axes, [&](int axis) {
      const double margin = margin_of(BoxPair(scratch_.frames[lo], scratch_.frames[hi], pair_->offset).normal(axis));
      if (edge.separation > margin) return;
      if (order >= 0) add_edge(lo, hi, axis, edge.separation, margin);
      if (order <= 0) add_edge(hi, lo, axis, edge.separation, margin);
    });
  }

  ManifoldSide side_of(BodyIndex reference, BodyIndex incident, double margin) const {
    const Vec3 d = reference < incident ? pair_->offset : plus_zero(Vec3(-pair_->offset));
    return {&scratch_.frames[reference], &scratch_.frames[incident], d, reference < incident, margin};
  }

  void add_face(BodyIndex reference, BodyIndex incident, int axis, double margin) {
    Manifold& m = fresh(reference, incident);
    face_manifold(side_of(reference, incident, margin), axis, m, out_.points);
    finish(m);
  }

  // axis: of (lower row, higher row).
  void add_edge(BodyIndex reference, BodyIndex incident, int axis, double separation, double margin) {
    Manifold& m = fresh(reference, incident);
    const ManifoldSide side = side_of(reference, incident, margin);
    const int i = (axis - 6) / 3, j = (axis - 6) % 3;
    const int own_axis = reference < incident ? axis : 6 + 3 * j + i;
    const BoxPair boxes(*side.reference, *side.incident, side.d);
    edge_manifold(side, boxes, own_axis, separation, m, out_.points);
    finish(m);
  }

  // The way that gravity may add, m, by which points are kept. A thin box that falls from rest may pass the next one in
  // a step, and would be held by points of boxes behind the next: beyond half its thickness a pair becomes a fast pair.
  double fall_of(double smallest) const { return std::min(fall_, smallest); }

  bool reaches(BodyIndex i, double fall) const {
    return scratch_.frames[i].position.z() - reach_along(scratch_.frames[i], 2) <= reach_of(i, fall);
  }
  double reach_of(BodyIndex i, double fall) const { return ground_reach(bodies_, scratch_, i, fall, dt_); }
  double fall_of(BodyIndex i) const { return fall_of(scratch_.frames[i].half_extent.minCoeff()); }

  void ground(BodyIndex i) {
    if (!reaches(i, fall_of(i))) return;
    Manifold& m = fresh(kGround, i);
    ground_manifold(scratch_.frames[i], reach_of(i, fall_of(i)), m, out_.points);
    finish(m);
  }

  // Appends an empty manifold with the material of the pair. Building in place saves a copy, which would stall on the
  // values just written.
  Manifold& fresh(BodyIndex reference, BodyIndex incident) {
    Manifold& m = out_.manifolds.emplace_back(empty_);
    m.a = reference;
    m.b = incident;
    set_materials(state_, m);
    return m;
  }

  // Removes points that cannot meet within the step, and recalls the impulses of the last step.
  void finish(Manifold& m) {
    if (m.a != kGround && pair_->later != 0) separate_as_now(bodies_, m, pair_->later, points_of(out_, m));
    const double smallest = m.a == kGround ? scratch_.frames[m.b].half_extent.minCoeff() : smallest_;
    const double way = m.a == kGround || in_substep_ ? way_if_hit(scratch_, m, dt_) : 0;
    const double margin = (slack_of(smallest) + fall_of(smallest)) + way;
    const PointReach reach = {dt_, pushing_s_, margin};
    pushes_ |= leave_points_in_reach(bodies_, reach, m, out_.points);
    if (m.count == 0) return out_.manifolds.pop_back();
    recall_.warm_start(m, points_of(out_, m));
  }

  const WorldState& state_;
  const Bodies& bodies_;
  const Scratch& scratch_;
  ManifoldList& out_;
  double dt_, substep_;        // s
  double fall_, sag_;          // m, ways that gravity may add within the step and within a substep
  double pushing_s_;           // s, within which points are pushed that would close: a sweep looks a substep ahead
  FreePaths paths_, ahead_;    // over the step; and over pushing_s_
  BodyIndex lo_ = 0, hi_ = 0;  // the pair at hand
  bool in_substep_ = false, pushes_ = false;  // the latter: whether a point of the pair at hand pushes
  double smallest_ = 0, turn_ = 0;            // m, of the pair at hand; turn_: way of corners by turning
  OpenOverlap open_{};
  Vec3 approach_ = Vec3::Zero();  // m/s, of the higher row against the lower
  TestedPair tested_{};
  const TestedPair* pair_ = nullptr;
  ContactRecall recall_;
  const Manifold empty_{};  // copying one is faster than making one
};

}  // namespace

void build_manifolds(const WorldState& state, const Scratch& scratch, double dt_s, const BodyRange& of,
                     ManifoldList& out, Hasher* hasher) {
  Builder(state, scratch, dt_s, state.contact_memory, of.memory, out).build(of.first, of.end, hasher);
}

void build_fast_manifolds(const WorldState& state, const Scratch& scratch, double substep_s, const FastRange& of,
                          ManifoldList& out) {
  Builder(state, scratch, substep_s, of.memory, memory_place(of.memory, of.pairs.front().first), out)
      .build_fast(of.pairs, of.approaches);
}

}  // namespace tumble::sim
