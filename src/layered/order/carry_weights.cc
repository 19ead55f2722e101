#include "src/layered/order/carry_weights.h"

#include <algorithm>
#include <cmath>

#include "src/math/grid.h"
#include "src/world/manifold_hashes.h"

namespace tumble::sim {
namespace {

constexpr double kBearing = 0.001;   // m; a point that is farther away bears nothing
constexpr double kSteepest = 0.5;    // a contact that takes less than this part of gravity along its normal leans
constexpr double kLendingSpeed = 1;  // m/s; inertia lent to a faster body would be energy out of nothing

using Support = WeightScratch::Support;
using Bearing = WeightScratch::Bearing;

// The bearing points under a body, seen from its centre, and the load on each as a linear function of its place: of all
// loads that balance the weight, those of least squares.
struct Footing {
  double count = 0, x = 0, y = 0;             // number of points, mean place
  double xx = 0, xy = 0, yy = 0;              // products about the mean, summed
  double even = 0, along_x = 0, along_y = 0;  // kg, kg/m

  [[nodiscard]] double load_at(double at_x, double at_y) const {
    return std::max(0.0, even + (along_x * (at_x - x) + along_y * (at_y - y)));
  }
};

class Walk {
 public:
  explicit Walk(WorldState& state, Scratch& scratch, double substep_s)
      : bodies_(state.bodies),
        scratch_(scratch),
        gravity_(state.def.gravity),
        substep_(substep_s),
        magic_(rounding_for(bodies_)),
        own_(scratch_.weights) {
    own_.carried = bodies_.mass;
    own_.moment_x.assign(bodies_.size(), 0);
    own_.moment_y.assign(bodies_.size(), 0);
    own_.waiting_for.assign(bodies_.size(), 0);
  }

  void run() {
    scratch_.solver_mass = bodies_.mass;
    find_supports();
    std::vector<BodyIndex>& ready = own_.ready;
    ready.clear();
    for (BodyIndex i = 0; i < bodies_.size(); ++i) {
      if (own_.waiting_for[i] == 0 && own_.start[i] < own_.start[i + 1]) ready.push_back(i);
    }
    // A body hands its load down when all that rests on it has; bodies that rest on each other in a ring never do.
    while (!ready.empty()) {
      const BodyIndex i = ready.back();
      ready.pop_back();
      find_bearings(i);
      const double scale = load_bearings(i);
      for (const Support& s : supports_of(i)) {
        hand_down(s, scale);
        if (s.lower != kGround && --own_.waiting_for[s.lower] == 0) ready.push_back(s.lower);
      }
    }
  }

 private:
  // Sums of n masses times lever arms are exact on this grid.
  static double rounding_for(const Bodies& bodies) {
    double heaviest = 0, squared_reach = 1;
    for (BodyIndex i = 0; i < bodies.size(); ++i) {
      if (bodies.is_static[i] != 0) continue;
      heaviest = std::max(heaviest, bodies.mass[i]);
      squared_reach = std::max(squared_reach, dot(bodies.half_extent[i], bodies.half_extent[i]));
    }
    const double reach = std::sqrt(squared_reach);
    return VelocityGrid::kMagic * (power_of_two(static_cast<double>(bodies.size()) * heaviest * reach) / 2048);
  }
  double rounded(double x) const { return (x + magic_) - magic_; }

  bool moves(BodyIndex i) const { return i != kGround && bodies_.moves(i); }
  Vec3 velocity_of(BodyIndex i) const { return moves(i) ? bodies_.velocity[i] : Vec3(Vec3::Zero()); }
  Vec3 spin_of(BodyIndex i) const { return moves(i) ? bodies_.spin[i] : Vec3(Vec3::Zero()); }

  bool is_new(const Manifold& m) const {
    const std::span<const ManifoldPoint> points = points_of(scratch_, m);
    return std::all_of(points.begin(), points.end(), [](const ManifoldPoint& p) { return p.impulse == 0; });
  }
  bool rests(const Manifold& m) const {
    const Vec3 v = (velocity_of(m.b) - velocity_of(m.a)) - cross(spin_of(m.a), m.d), w = spin_of(m.b) - spin_of(m.a);
    const double u = dot(v, m.n), w1 = dot(w, m.t1), w2 = dot(w, m.t2);
    const std::span<const ManifoldPoint> points = points_of(scratch_, m);
    return std::all_of(points.begin(), points.end(), [&](const ManifoldPoint& point) {
      return std::fabs(u + (w1 * point.q - w2 * point.p)) <= kRestingSpeed;
    });
  }

  void find_supports() {
    std::vector<Support>& found = own_.found;
    found.clear();
    own_.start.assign(bodies_.size() + 1, 0);
    for (const std::uint32_t k : scratch_.layered) {
      const Manifold& m = scratch_.manifolds[k];
      const double pull = -dot(gravity_, m.n);
      if (std::fabs(pull) < kSteepest * length(gravity_) || pull == 0) continue;
      const bool b_above = pull > 0;
      const BodyIndex upper = b_above ? m.b : m.a, lower = b_above ? m.a : m.b;
      if (!moves(upper)) continue;
      found.push_back({k, upper, moves(lower) ? lower : kGround, b_above ? Vec3(Vec3::Zero()) : m.d, std::fabs(pull)});
      ++own_.start[upper + 1];
      if (moves(lower)) ++own_.waiting_for[lower];
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) own_.start[i + 1] += own_.start[i];
    own_.supports.resize(found.size());
    own_.next.assign(own_.start.begin(), own_.start.end() - 1);
    for (const Support& s : found) own_.supports[own_.next[s.upper]++] = s;
  }
  std::span<Support> supports_of(BodyIndex i) {
    return std::span(own_.supports).subspan(own_.start[i], own_.start[i + 1] - own_.start[i]);
  }

  void find_bearings(BodyIndex i) {
    own_.bearings.clear();
    for (Support& s : supports_of(i)) {
      const Manifold& m = scratch_.manifolds[s.manifold];
      s.first_bearing = static_cast<std::uint32_t>(own_.bearings.size());
      for (ManifoldPoint& p : points_of(scratch_, m)) {
        if (p.separation >= kBearing) continue;
        const Vec3 r = s.origin + ((m.t1 * p.p + m.t2 * p.q) + m.n * m.offset);
        own_.bearings.push_back({&p, r.x(), r.y()});
      }
      s.end_bearing = static_cast<std::uint32_t>(own_.bearings.size());
    }
  }

  // Returns what loads have to be multiplied by to make up the body's weight.
  double load_bearings(BodyIndex i) {
    const Footing f = footing_of(i);
    double total = 0;  // kg, with what would have to pull left out
    for (Bearing& bearing : own_.bearings) {
      bearing.load = f.load_at(bearing.x, bearing.y);
      total += rounded(bearing.load);
    }
    return total > 0 ? own_.carried[i] / total : 0;
  }

  Footing footing_of(BodyIndex i) const {
    Footing f;
    if (own_.bearings.empty()) return f;
    f.count = static_cast<double>(own_.bearings.size());
    for (const Bearing& bearing : own_.bearings) {
      f.x += VelocityGrid::round(bearing.x);
      f.y += VelocityGrid::round(bearing.y);
    }
    f.x /= f.count;
    f.y /= f.count;
    for (const Bearing& bearing : own_.bearings) {
      const double x = bearing.x - f.x, y = bearing.y - f.y;
      f.xx += VelocityGrid::round(x * x);
      f.xy += VelocityGrid::round(x * y);
      f.yy += VelocityGrid::round(y * y);
    }
    balance(i, f);
    return f;
  }

  // Moments are taken about x and y, so with a tilted gravity the load is spread evenly.
  void balance(BodyIndex i, Footing& f) const {
    f.even = own_.carried[i] / f.count;
    if (gravity_.x() != 0 || gravity_.y() != 0) return;
    const double turn_x = own_.moment_x[i] - own_.carried[i] * f.x, turn_y = own_.moment_y[i] - own_.carried[i] * f.y;
    const double little = 1e-6 * (f.xx + f.yy);  // points in a row leave one slope open
    const double xx = f.xx + little, yy = f.yy + little;
    const double determinant = xx * yy - f.xy * f.xy;
    if (determinant <= 0) return;
    f.along_x = (yy * turn_x - f.xy * turn_y) / determinant;
    f.along_y = (xx * turn_y - f.xy * turn_x) / determinant;
  }

  void hand_down(const Support& s, double scale) {
    const bool starts = is_new(scratch_.manifolds[s.manifold]) && rests(scratch_.manifolds[s.manifold]);
    const bool hands_on = s.lower != kGround;
    const Vec3 apart = hands_on ? Vec3(bodies_.position[s.upper] - bodies_.position[s.lower]) : Vec3(Vec3::Zero());
    for (std::size_t k = s.first_bearing; k < s.end_bearing; ++k) {
      const Bearing& bearing = own_.bearings[k];
      const double load = bearing.load * scale;
      bearing.point->load = load * s.pull * substep_;
      if (starts) bearing.point->impulse = bearing.point->load;
      if (!hands_on) continue;
      own_.carried[s.lower] += rounded(load);
      own_.moment_x[s.lower] += rounded(load * (bearing.x + apart.x()));
      own_.moment_y[s.lower] += rounded(load * (bearing.y + apart.y()));
    }
    if (!hands_on) return;
    const Vec3 velocity = bodies_.velocity[s.lower];
    if (dot(velocity, velocity) > kLendingSpeed * kLendingSpeed) return;
    double& mass = scratch_.solver_mass[s.lower];
    mass = std::max(mass, scratch_.solver_mass[s.upper]);
  }

  const Bodies& bodies_;
  Scratch& scratch_;
  Vec3 gravity_;
  double substep_;
  double magic_;
  WeightScratch& own_;
};

}  // namespace

Status carry_weights(WorldState& state, Scratch& scratch, double dt_s) {
  Walk(state, scratch, dt_s / state.def.substeps).run();
  return {};
}

void hash_carry_weights(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  hasher.add(std::span<const double>(scratch.solver_mass));
  hash_manifold_points(scratch, hasher);
}

}  // namespace tumble::sim
