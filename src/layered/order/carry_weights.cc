#include "src/layered/order/carry_weights.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/layered/order/contact_motion.h"
#include "src/layered/order/find_blows.h"
#include "src/layered/order/lend_inertia.h"
#include "src/layered/order/load_fit.h"
#include "src/math/grid.h"
#include "src/world/manifold_hashes.h"

namespace tumble::sim {
namespace {

// Weights are passed down a graph: bodies are nodes, and an edge leads from a body to each body or ground that supports
// it. A body is treated when all supports above have been treated, so its load is complete (a topological order, after
// Kahn 1962). Then its load is divided among the points under it, and each point's share is added to the body below,
// together with its moment. The order among ready bodies does not show: shares are rounded to one grid (magic_), so the
// sums that they enter are exact in any order (src/math/grid.h). Sums over the points under one body, whose terms have
// no such bound, take their grid from the largest term.
//
// More than three points under a body leave the loads open: many sets of loads balance the weight. The sweeps would
// settle on one of them slowly. Least squares picks the set in which the load is a linear function of the place, as in
// a rigid plate on equal springs (the foundation of Winkler 1867). For a tower that set is exact.
constexpr double kBearing = 0.001;  // m; a point farther apart, or one that parts, bears nothing

using Support = WeightScratch::Support;
using SupportPoint = WeightScratch::SupportPoint;

class Walk {
 public:
  explicit Walk(WorldState& state, Scratch& scratch, double substep_s)
      : bodies_(state.bodies),
        scratch_(scratch),
        gravity_(state.def.gravity),
        tilt_(tilt_of(gravity_)),
        substep_(substep_s),
        reach_(farthest_reach(bodies_)),
        magic_(rounding_for(bodies_, reach_)),
        own_(scratch_.weights) {
    own_.borne.assign(bodies_.size(), 0);
    own_.moment_x.assign(bodies_.size(), 0);
    own_.moment_y.assign(bodies_.size(), 0);
    own_.waiting_for.assign(bodies_.size(), 0);
    own_.stands.assign(bodies_.size(), 0);
    own_.upward.assign(bodies_.size(), Vec3(Vec3::Zero()));
  }

  void run() {
    find_supports();
    find_blows(bodies_, gravity_, scratch_);
    std::vector<BodyIndex>& ready = own_.ready;
    ready.clear();
    own_.treated.clear();
    for (BodyIndex i = 0; i < bodies_.size(); ++i) {
      if (own_.waiting_for[i] == 0 && own_.start[i] < own_.start[i + 1]) ready.push_back(i);
    }
    // Bodies that rest on each other in a ring never become ready; the sweeps alone carry them.
    while (!ready.empty()) {
      const BodyIndex i = ready.back();
      ready.pop_back();
      own_.treated.push_back(i);
      find_points(i);
      own_.stands[i] = stands(i) ? 1 : 0;
      const double scale = load_points(i);
      for (Support& s : supports_of(i)) {
        pass_down(s, scale);
        if (s.lower != kGround && --own_.waiting_for[s.lower] == 0) ready.push_back(s.lower);
      }
    }
    find_held(scratch_);
    for (const BodyIndex i : own_.treated) {
      for (const Support& s : supports_of(i)) {
        if (s.starts && may_start(own_, s)) start(s);
      }
    }
  }

 private:
  Vec3 seen(const Vec3& place) const { return seen_along(tilt_, place); }

  // m, from the centre of a body to its corners; at least 1.
  static double farthest_reach(const Bodies& bodies) {
    double squared_reach = 1;
    for (BodyIndex i = 0; i < bodies.size(); ++i) {
      if (bodies.is_static[i] != 0) continue;
      squared_reach = std::max(squared_reach, dot(bodies.half_extent[i], bodies.half_extent[i]));
    }
    return std::sqrt(squared_reach);
  }
  // The magic number of a grid on which sums of n masses times lever arms of up to twice the reach are exact.
  static double rounding_for(const Bodies& bodies, double reach) {
    double heaviest = 0;
    for (BodyIndex i = 0; i < bodies.size(); ++i) {
      if (bodies.is_static[i] == 0) heaviest = std::max(heaviest, bodies.mass[i]);
    }
    return VelocityGrid::kMagic * (power_of_two(static_cast<double>(bodies.size()) * heaviest * reach) / 2048);
  }
  double rounded(double x) const { return to_grid(magic_, x); }

  // A point where fast bodies will meet may lie farther from where the lower one is now.
  double lever(double x) const { return std::clamp(x, -2 * reach_, 2 * reach_); }

  // kg. The mass lies on no grid, so it is added last.
  double carried(BodyIndex i) const { return bodies_.mass[i] + own_.borne[i]; }

  bool is_new(const Manifold& m) const {
    const std::span<const ManifoldPoint> points = points_of(scratch_, m);
    return std::all_of(points.begin(), points.end(), [](const ManifoldPoint& p) { return p.impulse == 0; });
  }
  bool rests(const Manifold& m) const {
    const Parting parting = parting_of(bodies_, m);
    const std::span<const ManifoldPoint> points = points_of(scratch_, m);
    return std::all_of(points.begin(), points.end(),
                       [&](const ManifoldPoint& point) { return std::fabs(parting.at(point)) <= kRestingSpeed; });
  }

  void find_supports() {
    std::vector<Support>& found = own_.found;
    found.clear();
    own_.start.assign(bodies_.size() + 1, 0);
    for (const std::uint32_t k : scratch_.layered) {
      const Manifold& m = scratch_.manifolds[k];
      const double pull = pull_along(gravity_, m);
      if (pull == 0) continue;
      const bool b_above = pull > 0;
      const BodyIndex upper = b_above ? m.b : m.a;
      if (!moves(bodies_, upper)) continue;
      const BodyIndex lower = moves(bodies_, b_above ? m.a : m.b) ? (b_above ? m.a : m.b) : kGround;
      found.push_back({k, upper, lower, b_above ? Vec3(Vec3::Zero()) : m.d, std::fabs(pull)});
      ++own_.start[upper + 1];
      if (lower != kGround) ++own_.waiting_for[lower];
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) own_.start[i + 1] += own_.start[i];
    own_.supports.resize(found.size());
    own_.next.assign(own_.start.begin(), own_.start.end() - 1);
    for (const Support& s : found) own_.supports[own_.next[s.upper]++] = s;
  }
  std::span<Support> supports_of(BodyIndex i) {
    return std::span(own_.supports).subspan(own_.start[i], own_.start[i + 1] - own_.start[i]);
  }

  void find_points(BodyIndex i) {
    own_.points.clear();
    for (Support& s : supports_of(i)) {
      const Manifold& m = scratch_.manifolds[s.manifold];
      s.first_point = static_cast<std::uint32_t>(own_.points.size());
      const Parting parting = parting_of(bodies_, m);
      for (ManifoldPoint& p : points_of(scratch_, m)) {
        if (p.separation >= kBearing || parting.at(p) > kRestingSpeed) continue;
        const Vec3 r = seen(s.origin + ((m.t1 * p.p + m.t2 * p.q) + m.n * m.offset));
        own_.points.push_back({&p, r.x(), r.y()});
      }
      s.end_point = static_cast<std::uint32_t>(own_.points.size());
    }
  }

  // Sets the loads of the points. Returns the factor that makes the loads add up to the weight carried.
  double load_points(BodyIndex i) {
    const LoadFit f = fit_loads(own_.points, {carried(i), own_.moment_x[i], own_.moment_y[i]}, tilt_.z() != 0);
    for (SupportPoint& point : own_.points) point.load = f.load_at(point.x, point.y);  // kg
    double total = sum_of_loads(magic_);
    // Points almost in a row get loads far beyond the weight. A sum without negative terms tells of itself that its
    // grid was too narrow.
    if (total > 1.25 * magic_) total = sum_of_loads(fitting_magic(magic_, largest_load() * terms()));
    return total > 0 ? carried(i) / total : 0;
  }

  double largest_load() const {
    double largest = 0;
    for (const SupportPoint& point : own_.points) largest = std::max(largest, point.load);
    return largest;
  }
  double sum_of_loads(double magic) const {  // kg
    double total = 0;
    for (const SupportPoint& point : own_.points) total += to_grid(magic, point.load);
    return total;
  }

  bool stands(BodyIndex i) const {
    if (own_.struck[i] != 0) return false;
    if (tilt_.z() == 0) return !own_.points.empty() && own_.first_blow[i] == WeightScratch::kNoBlow;
    for (std::uint32_t k = own_.first_blow[i]; k != WeightScratch::kNoBlow; k = own_.blows[k].next) {
      if (!press_between(own_.points, own_.blows[k].x, own_.blows[k].y)) return false;
    }
    return press_between(own_.points, own_.moment_x[i] / carried(i), own_.moment_y[i] / carried(i));
  }

  // For fitting_magic: the number of terms of a sum over the points.
  double terms() const { return std::max(4.0, static_cast<double>(own_.points.size())); }

  // m/s, of b over a along t1 and t2.
  std::pair<double, double> slip_of(const Manifold& m) const {
    const Vec3 v = velocity_across(bodies_, m), w = spin_of(bodies_, m.b) - spin_of(bodies_, m.a);
    return {dot(v, m.t1) + dot(w, m.t2) * m.offset, dot(v, m.t2) - dot(w, m.t1) * m.offset};
  }
  static bool slow(double x, double y) { return x * x + y * y <= kRestingSpeed * kRestingSpeed; }

  // A new contact starts from its load, kg. Friction starts from what holds the load on a slope or, where the bodies
  // slip, from what opposes the slip.
  void start(const Support& s) const {
    Manifold& m = scratch_.manifolds[s.manifold];
    for (ManifoldPoint& point : points_of(scratch_, m)) point.impulse = point.load;
    const auto [slip1, slip2] = slip_of(m);
    if (slow(slip1, slip2)) {
      const double up = (s.upper == m.b ? -s.load : s.load) * substep_;
      m.force1 = up * dot(gravity_, m.t1);
      m.force2 = up * dot(gravity_, m.t2);
    } else {
      const double speed = std::sqrt(slip1 * slip1 + slip2 * slip2);
      const double against = -(s.load * s.pull) * (m.friction_dynamic * substep_) / speed;
      m.force1 = against * slip1;
      m.force2 = against * slip2;
    }
  }

  void pass_down(Support& s, double scale) {
    Manifold& m = scratch_.manifolds[s.manifold];
    s.bears = s.first_point < s.end_point;
    s.starts = is_new(m) && rests(m);
    s.load = 0;
    const bool passes_on = s.lower != kGround;
    const Vec3 apart = passes_on ? seen(bodies_.position[s.upper] - bodies_.position[s.lower]) : Vec3(Vec3::Zero());
    for (std::size_t k = s.first_point; k < s.end_point; ++k) {
      const SupportPoint& point = own_.points[k];
      const double load = point.load * scale;
      s.load += rounded(load);
      point.point->load = load * s.pull * substep_;
      if (!passes_on) continue;
      own_.borne[s.lower] += rounded(load);
      own_.moment_x[s.lower] += rounded(load * lever(point.x + apart.x()));
      own_.moment_y[s.lower] += rounded(load * lever(point.y + apart.y()));
    }
    const double up = s.upper == m.b ? s.load : -s.load;
    own_.upward[s.upper] += Vec3(rounded(up * m.n.x()), rounded(up * m.n.y()), rounded(up * m.n.z()));
  }

  const Bodies& bodies_;
  Scratch& scratch_;
  Vec3 gravity_;
  Vec3 tilt_;
  double substep_;
  double reach_, magic_;
  WeightScratch& own_;
};

}  // namespace

Status carry_weights(WorldState& state, Scratch& scratch, double dt_s) {
  Walk(state, scratch, dt_s / state.def.substeps).run();
  lend_inertia(state, scratch);
  return {};
}

void hash_carry_weights(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  hasher.add(std::span<const double>(scratch.solver_mass));
  hasher.add(doubles_of(scratch.lent_along));
  hash_manifold_points(scratch, hasher);
}

}  // namespace tumble::sim
