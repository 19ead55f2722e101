#include "src/layered/order/find_blows.h"

#include <numeric>
#include <span>

#include "src/layered/order/contact_motion.h"
#include "src/math/grid.h"

namespace tumble::sim {
namespace {

constexpr double kTippingLever = 0.1;  // of the smallest half extent; a hit from the side with less of it only pushes

// m, the middle of a manifold's points from the centre of body b.
Vec3 middle_of(const Scratch& scratch, const Manifold& m) {
  Vec3 sum = Vec3::Zero();
  const std::span<const ManifoldPoint> points = points_of(scratch, m);
  for (const ManifoldPoint& p : points) {
    sum += PositionGrid::round_any(Vec3((m.t1 * p.p + m.t2 * p.q) + m.n * m.offset));
  }
  return sum / static_cast<double>(points.size());
}

class Blows {
 public:
  // next: the first of the worker's places in `blows`.
  Blows(const Bodies& bodies, const Vec3& gravity, Scratch& scratch, const Worker& worker, std::uint32_t next)
      : bodies_(bodies),
        gravity_(gravity),
        tilt_(tilt_of(gravity)),
        scratch_(scratch),
        own_(scratch.weights),
        worker_(worker),
        next_(next) {}

  void add(const Manifold& m) {
    const Vec3 from_b = middle_of(scratch_, m), from_a = m.d + from_b;
    const double pull = pull_along(gravity_, m);
    if (pull == 0) {
      strike_aside(m.a, from_a, m.n);
      strike_aside(m.b, from_b, m.n);
      return;
    }
    const bool b_above = pull > 0;
    const BodyIndex upper = b_above ? m.b : m.a, lower = b_above ? m.a : m.b;
    if (!moves(bodies_, lower)) return;
    const Vec3 place = b_above ? from_a : from_b;
    const Vec3 comes = bodies_.velocity[lower] + cross(bodies_.spin[lower], place);
    const double upwards = b_above ? dot(comes, m.n) : -dot(comes, m.n);
    if (upwards > kRestingSpeed && moves(bodies_, upper)) mark(own_.struck[upper]);
    strike_down(lower, seen_along(tilt_, place));
  }

 private:
  void strike_aside(BodyIndex i, const Vec3& place, const Vec3& normal) {
    if (!moves(bodies_, i)) return;
    const Vec3 lever = cross(place, normal);
    const Vec3 tipping = lever - gravity_ * (dot(lever, gravity_) / dot(gravity_, gravity_));
    const double least = kTippingLever * bodies_.half_extent[i].minCoeff();
    if (dot(tipping, tipping) > least * least) mark(own_.struck[i]);
  }

  void strike_down(BodyIndex i, const Vec3& place) {
    WeightScratch::Blow& blow = own_.blows[next_];
    blow = {place.x(), place.y(), WeightScratch::kNoBlow};
    do {
      blow.next = own_.first_blow[i];
    } while (!worker_.exchange(own_.first_blow[i], blow.next, next_));
    ++next_;
  }

  const Bodies& bodies_;
  Vec3 gravity_, tilt_;
  const Scratch& scratch_;
  WeightScratch& own_;
  Worker worker_;
  std::uint32_t next_;
};

}  // namespace

void find_blows(const Bodies& bodies, const Vec3& gravity, Scratch& scratch, const Worker& worker) {
  if (gravity == Vec3::Zero()) return;
  WeightScratch& own = scratch.weights;
  const std::size_t n = scratch.manifolds.size();
  std::uint32_t count = 0;
  const auto find = [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      own.meets[k] = scratch.graph.links[k].awake && meets(bodies, scratch, scratch.manifolds[k]) ? 1 : 0;
      count += own.meets[k];
    }
  };
  scratch.manifold_homes.for_own(worker, n, find);
  own.meeting[worker.part] = count;
  if (!worker.meet(count > 0)) return;
  const auto before = own.meeting.begin() + worker.part;
  if (worker.first()) own.blows.resize(std::accumulate(own.meeting.begin(), own.meeting.end(), std::size_t{0}));
  worker.meet();
  Blows blows(bodies, gravity, scratch, worker, std::accumulate(own.meeting.begin(), before, 0U));
  const auto add = [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (own.meets[k] != 0) blows.add(scratch.manifolds[k]);
    }
  };
  scratch.manifold_homes.for_own(worker, n, add);
}

}  // namespace tumble::sim
