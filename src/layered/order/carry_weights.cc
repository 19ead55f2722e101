#include "src/layered/order/carry_weights.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "src/layered/islands/island_scale.h"
#include "src/layered/order/contact_graph.h"
#include "src/layered/order/contact_motion.h"
#include "src/layered/order/find_blows.h"
#include "src/layered/order/find_supports.h"
#include "src/layered/order/lend_inertia.h"
#include "src/layered/order/load_fit.h"
#include "src/math/grid.h"
#include "src/world/hash_on_the_way.h"

namespace tumble::sim {
namespace {

// Weights are passed down a graph: bodies are nodes, and an edge leads from a body to each body or ground that supports
// it. A body is treated when all supports above have been treated, so its load is complete (a topological order, after
// Kahn 1962). Then its load is divided among the points under it, and each point's share is added to the body below,
// together with its moment. The order among ready bodies does not show: shares are rounded to one grid of the island,
// so the sums that they enter are exact in any order (src/math/grid.h). Sums over the points under one body, whose
// terms have no such bound, take their grid from the largest term.
//
// More than three points under a body leave the loads open: many sets of loads balance the weight. The sweeps would
// settle on one of them slowly. Least squares picks the set in which the load is a linear function of the place, as in
// a rigid plate on equal springs (the foundation of Winkler 1867). For a tower that set is exact.
constexpr std::uint32_t kOneLess = 0xffffffffU;  // added, takes one away

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
        own_(scratch_.weights) {}

  /// What one of several workers does.
  void run(const WorldState& state, const Worker& worker) {
    Waves waves(scratch_.waves, bodies_.size(), scratch_.homes, worker);
    const auto for_own = [&](auto visit) { scratch_.homes.for_own(worker, bodies_.size(), visit); };
    for_own([&](std::size_t begin, std::size_t end) { clear(begin, end); });
    if (worker.first()) own_.meets.resize(scratch_.manifolds.size());
    worker.meet();
    find_supports(bodies_, scratch_, worker);
    find_blows(bodies_, gravity_, scratch_, worker);
    for_own([&](std::size_t begin, std::size_t end) {
      for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) {
        if (own_.waiting_for[i] == 0 && own_.start[i] < own_.start[i + 1]) waves.push(i);
      }
    });
    // Bodies that rest on each other in a ring never become ready; the sweeps alone carry them.
    std::vector<SupportPoint>& points = own_.points[worker.part];
    waves.walk([&](BodyIndex i) {
      find_points(i, points);
      own_.stands[i] = stands(i, points) ? 1 : 0;
      const IslandScale scale = scale_of(scratch_.islands, i);
      const double part = load_points(i, points, scale);
      for (Support& s : supports_of(i)) {
        const Worker by = who_adds(scratch_.graph, s.lower, worker);
        pass_down(s, points, part, scale, by);
        if (s.lower != kGround && by.add(own_.waiting_for[s.lower], kOneLess) == 1) waves.push(s.lower);
      }
    });
    find_held(scratch_, waves);
    waves.for_all([&](BodyIndex i) {
      for (const Support& s : supports_of(i)) {
        if (s.starts && may_start(own_, s)) start(s);
      }
    });
    lend_inertia(state, scratch_, waves);
  }

 private:
  Vec3 seen(const Vec3& place) const { return seen_along(tilt_, place); }

  // Of a range of bodies.
  void clear(std::size_t begin, std::size_t end) {
    const auto fill = [&](auto& column, const auto& value) {
      std::fill(column.begin() + static_cast<std::ptrdiff_t>(begin), column.begin() + static_cast<std::ptrdiff_t>(end),
                value);
    };
    for (std::vector<double>* column : {&own_.borne, &own_.moment_x, &own_.moment_y}) fill(*column, 0);
    for (std::vector<std::uint8_t>* column : {&own_.stands, &own_.held, &own_.settled, &own_.struck}) fill(*column, 0);
    fill(own_.first_blow, WeightScratch::kNoBlow);
    fill(scratch_.lent_along, Vec3(Vec3::Zero()));
    for (std::size_t i = begin; i < end; ++i) {
      own_.offered[i] = scratch_.solver_mass[i] = bodies_.mass[i];
    }
  }

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

  std::span<Support> supports_of(BodyIndex i) {
    return std::span(own_.supports).subspan(own_.start[i], own_.start[i + 1] - own_.start[i]);
  }

  void find_points(BodyIndex i, std::vector<SupportPoint>& found) {
    found.clear();
    for (Support& s : supports_of(i)) {
      const Manifold& m = scratch_.manifolds[s.manifold];
      s.first_point = static_cast<std::uint32_t>(found.size());
      const Parting parting = parting_of(bodies_, m);
      const Vec3 origin = i == m.b ? Vec3(Vec3::Zero()) : m.d;  // of p, q and offset, from the upper body's centre
      for (ManifoldPoint& p : points_of(scratch_, m)) {
        if (p.separation >= kBearing || parting.at(p) > kRestingSpeed) continue;
        const Vec3 r = seen(origin + ((m.t1 * p.p + m.t2 * p.q) + m.n * m.offset));
        found.push_back({&p, r.x(), r.y()});
      }
      s.end_point = static_cast<std::uint32_t>(found.size());
    }
  }

  // Sets the loads of the points. Returns the factor that makes the loads add up to the weight carried.
  double load_points(BodyIndex i, std::span<SupportPoint> points, const IslandScale& scale) const {
    const LoadFit f = fit_loads(points, {carried(i), own_.moment_x[i], own_.moment_y[i]}, tilt_.z() != 0);
    for (SupportPoint& point : points) point.load = f.load_at(point.x, point.y);  // kg
    double total = sum_of_loads(points, scale.magic);
    // Points almost in a row get loads far beyond the weight. A sum without negative terms tells of itself that its
    // grid was too narrow.
    if (total > 1.25 * scale.magic) {
      const double terms = std::max(4.0, static_cast<double>(points.size()));  // as fitting_magic wants it
      total = sum_of_loads(points, fitting_magic(scale.magic, largest_load(points) * terms));
    }
    return total > 0 ? carried(i) / total : 0;
  }

  static double largest_load(std::span<const SupportPoint> points) {
    double largest = 0;
    for (const SupportPoint& point : points) largest = std::max(largest, point.load);
    return largest;
  }
  static double sum_of_loads(std::span<const SupportPoint> points, double magic) {  // kg
    double total = 0;
    for (const SupportPoint& point : points) total += to_grid(magic, point.load);
    return total;
  }

  bool stands(BodyIndex i, std::span<const SupportPoint> points) const {
    if (own_.struck[i] != 0) return false;
    if (tilt_.z() == 0) return !points.empty() && own_.first_blow[i] == WeightScratch::kNoBlow;
    for (std::uint32_t k = own_.first_blow[i]; k != WeightScratch::kNoBlow; k = own_.blows[k].next) {
      if (!press_between(points, own_.blows[k].x, own_.blows[k].y)) return false;
    }
    return press_between(points, own_.moment_x[i] / carried(i), own_.moment_y[i] / carried(i));
  }

  // m/s, of b over a along t1 and t2.
  std::pair<double, double> slip_of(const Manifold& m) const {
    const Vec3 v = velocity_across(bodies_, m), w = spin_of(bodies_, m.b) - spin_of(bodies_, m.a);
    return {dot(v, m.t1) + dot(w, m.t2) * m.offset, dot(v, m.t2) - dot(w, m.t1) * m.offset};
  }
  // m/s², gravity along the normal.
  double pull_of(const Manifold& m) const { return std::fabs(pull_along(gravity_, m)); }
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
      const double against = -(s.load * pull_of(m)) * (m.friction_dynamic * substep_) / speed;
      m.force1 = against * slip1;
      m.force2 = against * slip2;
    }
  }

  void pass_down(Support& s, std::span<const SupportPoint> points, double part, const IslandScale& scale,
                 const Worker& worker) {
    const Manifold& m = scratch_.manifolds[s.manifold];
    s.bears = s.first_point < s.end_point;
    s.starts = is_new(m) && rests(m);
    s.load = 0;
    const bool passes_on = s.lower != kGround;
    const double pull = pull_of(m);
    const Vec3 apart = passes_on ? seen(bodies_.position[s.upper] - bodies_.position[s.lower]) : Vec3(Vec3::Zero());
    double moment_x = 0, moment_y = 0;
    for (const SupportPoint& point : points.subspan(s.first_point, s.end_point - s.first_point)) {
      const double load = point.load * part;
      s.load += scale.rounded(load);
      point.point->load = load * pull * substep_;
      if (!passes_on) continue;
      moment_x += scale.rounded(load * scale.lever(point.x + apart.x()));
      moment_y += scale.rounded(load * scale.lever(point.y + apart.y()));
    }
    if (passes_on && s.bears) {
      worker.add(own_.borne[s.lower], s.load);
      worker.add(own_.moment_x[s.lower], moment_x);
      worker.add(own_.moment_y[s.lower], moment_y);
    }
    const double up = s.upper == m.b ? s.load : -s.load;
    upward_of(scratch_)[s.upper] +=
        Vec3(scale.rounded(up * m.n.x()), scale.rounded(up * m.n.y()), scale.rounded(up * m.n.z()));
  }

  const Bodies& bodies_;
  Scratch& scratch_;
  Vec3 gravity_;
  Vec3 tilt_;
  double substep_;
  WeightScratch& own_;
};

// Memory for all bodies, whose values the workers write.
void make_room(Scratch& scratch, std::size_t bodies, unsigned workers) {
  WeightScratch& own = scratch.weights;
  for (auto* column : {&own.borne, &own.moment_x, &own.moment_y, &own.offered, &scratch.solver_mass}) {
    column->resize(bodies);
  }
  for (auto* column : {&own.stands, &own.held, &own.settled, &own.struck}) column->resize(bodies);
  scratch.lent_along.resize(bodies);
  own.waiting_for.resize(bodies);
  own.first_blow.resize(bodies);
  own.start.resize(bodies + 1);
  own.meeting.assign(workers, 0);
  if (own.points.size() < workers) own.points.resize(workers);
  for (auto& points : own.points) points.reserve(kPointsMax);
}

}  // namespace

Status carry_weights(WorldState& state, Scratch& scratch, double dt_s) {
  const unsigned parts = part_count(scratch.workers, scratch.manifolds.size(), kManifoldsAPart);
  make_room(scratch, state.bodies.size(), parts);
  measure_islands(state.bodies, scratch);
  Walk walk(state, scratch, dt_s / state.def.substeps);
  work_together(scratch.workers, parts, [&](const Worker& worker) { walk.run(state, worker); });
  return {};
}

void hash_carry_weights(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  hasher.add(std::span<const double>(scratch.solver_mass));
  hasher.add(doubles_of(scratch.lent_along));
  hasher.add(std::span<const std::uint8_t>(scratch.weights.held));
  GatheredNumbers numbers(&hasher);
  for (const ManifoldPoint& point : scratch.manifold_points) {
    double* const of_point = numbers.next(2);
    of_point[0] = point.impulse, of_point[1] = point.load;
  }
}

}  // namespace tumble::sim
