#include "src/layered/find/find_manifolds.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

#include "src/kernels/box_pair.h"
#include "src/layered/find/contact_recall.h"
#include "src/layered/find/find_near_pairs.h"
#include "src/layered/find/manifold_points.h"
#include "src/layered/find/pair_tests.h"
#include "src/world/manifold_hashes.h"

namespace tumble::sim {
namespace {

constexpr std::size_t kWorthPairs = 16384;  // and bodies, that pay for one more worker

// The number of pairs before those of a body.
std::size_t pairs_before(const PairTable& pairs, BodyIndex i) {
  return static_cast<std::size_t>(std::ranges::lower_bound(pairs.a, i) - pairs.a.begin());
}

// The first body of a part; all parts get about one number of pairs and bodies.
BodyIndex first_body(const WorldState& state, unsigned part, unsigned parts) {
  const PairTable& pairs = state.pairs;
  const std::size_t n = state.bodies.size(), wanted = (pairs.size() + n) * part / parts;
  BodyIndex low = 0, high = static_cast<BodyIndex>(n);
  while (low < high) {
    const BodyIndex middle = low + (high - low) / 2;
    if (pairs_before(pairs, middle) + middle < wanted) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

// Exchanges the lists of the scratch with those of the first worker, who then finds into the former without a copy.
void swap_first(Scratch& scratch) {
  std::swap(scratch.manifolds, scratch.manifolds_by[0].manifolds);
  std::swap(scratch.manifold_points, scratch.manifolds_by[0].points);
}

// Joins the lists of all workers in order of bodies; copies those of all but the first.
void join(Scratch& scratch, unsigned parts) {
  swap_first(scratch);
  if (parts == 1) return;
  std::size_t manifolds = scratch.manifolds.size(), points = scratch.manifold_points.size();
  for (unsigned part = 1; part < parts; ++part) {
    ManifoldList& list = scratch.manifolds_by[part];
    list.manifolds_before = manifolds;
    list.points_before = points;
    manifolds += list.manifolds.size();
    points += list.points.size();
  }
  scratch.manifolds.resize(manifolds);
  scratch.manifold_points.resize(points);
  for_parts(scratch.workers, parts, [&](unsigned part) {
    if (part == 0) return;
    ManifoldList& list = scratch.manifolds_by[part];
    for (Manifold& m : list.manifolds) m.first += static_cast<std::uint32_t>(list.points_before);
    std::ranges::copy(list.manifolds, scratch.manifolds.begin() + static_cast<std::ptrdiff_t>(list.manifolds_before));
    std::ranges::copy(list.points, scratch.manifold_points.begin() + static_cast<std::ptrdiff_t>(list.points_before));
  });
}

// The limit of manifolds. A manifold takes 2 kB, and n bodies in one place would make n² of them.
constexpr std::size_t manifolds_max(std::size_t bodies) { return 32768 + 16 * bodies; }

// Builds the manifolds of a range of bodies.
class Builder {
 public:
  // For the bodies [first, end).
  Builder(const WorldState& state, const Scratch& scratch, double dt_s, BodyIndex first, BodyIndex end,
          ManifoldList& out)
      : state_(state),
        bodies_(state.bodies),
        scratch_(scratch),
        out_(out),
        first_(first),
        end_(end),
        dt_(dt_s),
        fall_(falling_reach(state.def, dt_s)),
        tests_(state, scratch, dt_s, pairs_before(state.pairs, first), pairs_before(state.pairs, end)),
        recall_(state.contact_memory, first) {
    out_.manifolds.clear();
    out_.points.clear();
  }

  // Builds the manifolds of each body with bodies of higher rows and with the ground.
  void build() {
    const PairTable& pairs = state_.pairs;
    std::size_t k = pairs_before(pairs, first_);
    const std::size_t most = manifolds_max(bodies_.size());
    for (BodyIndex i = first_; i < end_ && out_.manifolds.size() <= most; ++i) {
      for (; k < pairs.size() && pairs.a[k] == i; ++k) pair(i, pairs.b[k]);
      if (state_.def.ground && bodies_.is_static[i] == 0) ground(i);
    }
  }

 private:
  double turning(BodyIndex i) const { return scratch_.turning[i]; }

  void pair(BodyIndex lo, BodyIndex hi) {
    if (!bodies_.moves(lo) && !bodies_.moves(hi)) return recall_.keep(lo, hi, out_);
    pair_ = tests_.next();
    if (pair_ == nullptr) return;
    const BoxFrame& a = scratch_.frames[lo];
    const BoxFrame& b = scratch_.frames[hi];
    const double smallest = smallest_half_extent(a, b);
    const Vec3 approach = bodies_.velocity[hi] - bodies_.velocity[lo];
    const double turn = turning(lo) + turning(hi);
    const auto margin_of = [&](const Vec3& n) {
      return std::max(0.0, -dot(approach, n)) * dt_ + (turn + fall_) + slack_of(smallest);
    };
    const BestAxes &face_lo = pair_->face_a, &face_hi = pair_->face_b, &edge = pair_->edge;
    const Vec3& offset = pair_->offset;
    const double face = larger_separation(face_lo, face_hi);
    const bool lo_first = canonical(a, b, offset) >= 0, hi_first = canonical(a, b, offset) <= 0;
    if (edge.axes != 0 && edge.separation > face + kEdgePreference * smallest) {
      for_each_axis(edge.axes, [&](int axis) {
        const double margin = margin_of(BoxPair(a, b, offset).normal(axis));
        if (edge.separation > margin) return;
        if (lo_first) add_edge(lo, hi, axis, margin);
        if (hi_first) add_edge(hi, lo, axis, margin);
      });
      return;
    }
    const double prefer = kFacePreference * smallest;
    const bool on_lo = face_lo.axes != 0 && (lo_first ? face_lo.separation >= face - prefer
                                                      : face_lo.separation > face_hi.separation + prefer);
    const bool on_hi = face_hi.axes != 0 && (hi_first ? face_hi.separation >= face - prefer
                                                      : face_hi.separation > face_lo.separation + prefer);
    if (on_lo) {
      for_each_axis(face_lo.axes, [&](int axis) { add_face(lo, hi, axis, margin_of(towards(offset, a.axes[axis]))); });
    }
    if (on_hi) {
      for_each_axis(face_hi.axes,
                    [&](int axis) { add_face(hi, lo, axis - 3, margin_of(towards(offset, b.axes[axis - 3]))); });
    }
  }

  // Which box is the reference: > 0: a, < 0: b, 0: a tie.
  static int canonical(const BoxFrame& box_a, const BoxFrame& box_b, const Vec3& offset) {
    const double a = volume_measure(box_a), b = volume_measure(box_b);
    if (a != b) return a > b ? 1 : -1;
    const double up = offset.z();
    return up > 0 ? 1 : up < 0 ? -1 : 0;
  }

  static Vec3 towards(const Vec3& offset, const Vec3& axis) { return dot(offset, axis) < 0 ? Vec3(-axis) : axis; }

  template <class Visit>
  static void for_each_axis(AxisSet axes, Visit visit) {
    for (unsigned rest = axes; rest != 0; rest &= rest - 1) visit(std::countr_zero(rest));
  }

  ManifoldSide side_of(BodyIndex reference, BodyIndex incident, double margin) const {
    const Vec3 d = reference < incident ? pair_->offset : plus_zero(Vec3(-pair_->offset));
    return {&scratch_.frames[reference], &scratch_.frames[incident], d, reference < incident, margin};
  }

  void add_face(BodyIndex reference, BodyIndex incident, int axis, double margin) {
    Manifold& m = fresh(reference, incident);
    face_manifold(side_of(reference, incident, margin), axis, m, out_.points);
    separate_as_now(m);
    finish(m);
  }

  // axis: of (lower row, higher row).
  void add_edge(BodyIndex reference, BodyIndex incident, int axis, double margin) {
    Manifold& m = fresh(reference, incident);
    const ManifoldSide side = side_of(reference, incident, margin);
    const int i = (axis - 6) / 3, j = (axis - 6) % 3;
    const int own_axis = reference < incident ? axis : 6 + 3 * j + i;
    const BoxPair boxes(*side.reference, *side.incident, side.d);
    edge_manifold(side, boxes, own_axis, pair_->edge.separation, m, out_.points);
    separate_as_now(m);
    finish(m);
  }

  // The points lie where the boxes will meet; the separations become those of now.
  void separate_as_now(const Manifold& m) {
    if (pair_->later == 0) return;
    const double opening = dot(Vec3(bodies_.velocity[m.b] - bodies_.velocity[m.a]), m.n);
    for (ManifoldPoint& point : points_of(out_, m)) point.separation -= pair_->later * opening;
  }

  void ground(BodyIndex i) {
    if (!bodies_.moves(i)) return recall_.keep(i, kGround, out_);
    const BoxFrame& frame = scratch_.frames[i];
    const double slack = slack_of(frame.half_extent.minCoeff());
    const double reach = std::max(0.0, -bodies_.velocity.z[i]) * dt_ + (turning(i) + fall_) + slack;
    if (frame.position.z() - reach_along(frame, 2) > reach) return;
    Manifold& m = fresh(kGround, i);
    ground_manifold(frame, reach, m, out_.points);
    finish(m);
  }

  // Appends an empty manifold with the material of the pair. Building in place saves a copy, which would stall on the
  // values just written.
  Manifold& fresh(BodyIndex reference, BodyIndex incident) {
    out_.manifolds.push_back(empty_);
    Manifold& m = out_.manifolds.back();
    m.a = reference;
    m.b = incident;
    const WorldDef& def = state_.def;
    const bool ground = reference == kGround;
    const double f = ground ? def.ground_material.friction : bodies_.friction[reference];
    const double fd = ground ? def.ground_material.friction_dynamic : bodies_.friction_dynamic[reference];
    const double e = ground ? def.ground_material.restitution : bodies_.restitution[reference];
    m.friction = std::sqrt(f * bodies_.friction[incident]);
    m.friction_dynamic = std::sqrt(fd * bodies_.friction_dynamic[incident]);
    m.restitution = std::max(e, bodies_.restitution[incident]);
    return m;
  }

  // Removes points that cannot meet within the step, and recalls the impulses of the last step.
  void finish(Manifold& m) {
    std::vector<ManifoldPoint>& points = out_.points;
    const Vec3 va = m.a == kGround ? Vec3(Vec3::Zero()) : bodies_.velocity[m.a];
    const Vec3 wa = m.a == kGround ? Vec3(Vec3::Zero()) : bodies_.spin[m.a];
    const Vec3 u = (bodies_.velocity[m.b] - va) - cross(wa, m.d), w = bodies_.spin[m.b] - wa;
    const double un = dot(u, m.n), w1 = dot(w, m.t1), w2 = dot(w, m.t2);
    double smallest = scratch_.frames[m.b].half_extent.minCoeff();
    if (m.a != kGround) smallest = std::min(smallest, scratch_.frames[m.a].half_extent.minCoeff());
    const double reach = slack_of(smallest) + fall_;
    std::size_t kept = m.first;
    for (std::size_t k = m.first; k < points.size(); ++k) {
      const double speed = un + (w1 * points[k].q - w2 * points[k].p);
      if (points[k].separation + std::min(0.0, speed) * dt_ > reach) continue;
      if (kept != k) points[kept] = points[k];  // a copy onto itself would stall
      ++kept;
    }
    points.resize(kept);
    m.count = static_cast<std::uint32_t>(kept - m.first);
    if (m.count == 0) return out_.manifolds.pop_back();
    recall_.warm_start(m, points_of(out_, m));
  }

  const WorldState& state_;
  const Bodies& bodies_;
  const Scratch& scratch_;
  ManifoldList& out_;
  BodyIndex first_, end_;
  double dt_;
  double fall_;  // m, way that gravity may add within the step
  PairTests tests_;
  const TestedPair* pair_ = nullptr;
  ContactRecall recall_;
  const Manifold empty_{};  // copying one is faster than making one
};

}  // namespace

Status find_manifolds(WorldState& state, Scratch& scratch, double dt_s) {
  const std::size_t work = state.pairs.size() + state.bodies.size();
  const unsigned parts = part_count(scratch.workers, work, kWorthPairs);
  if (scratch.manifolds_by.size() < parts) scratch.manifolds_by.resize(parts);
  swap_first(scratch);
  for_parts(scratch.workers, parts, [&](unsigned part) {
    Builder(state, scratch, dt_s, first_body(state, part, parts), first_body(state, part + 1, parts),
            scratch.manifolds_by[part])
        .build();
  });
  std::size_t found = 0;
  for (unsigned part = 0; part < parts; ++part) found += scratch.manifolds_by[part].manifolds.size();
  const std::size_t n = state.bodies.size(), most = manifolds_max(n);
  if (found > most) {
    return cannot_finish("found more than " + std::to_string(most) + " contacts of " + std::to_string(n) +
                         " bodies; so many stand inside one another: set them farther apart");
  }
  join(scratch, parts);
  return {};
}

void hash_find_manifolds(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  hash_manifolds(scratch, hasher);
}

}  // namespace tumble::sim
