#include "replay/measure/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "replay/format/not_finite.h"
#include "replay/measure/measure_overlap.h"
#include "src/base/check.h"
#include "src/model/mass.h"

namespace tumble::replay {
namespace {

using sim::Vec3;
using Kind = Shape::Kind;

bool is(const Solid& body, Kind kind) { return body.shape != nullptr && body.shape->kind == kind; }
bool is_box(const Solid& body) { return body.shape == nullptr; }
/// A segment with a radius around it.
bool is_round(const Solid& body) { return is(body, Kind::kSphere) || is(body, Kind::kCapsule); }

const Vec3& axis_of(const Solid& body) { return body.frame.axes[body.shape->axis]; }

/// Half of the segment within a round body; zero of a sphere.
Vec3 segment_of(const Solid& body) {
  return is(body, Kind::kSphere) ? Vec3(0, 0, 0) : Vec3(axis_of(body) * body.shape->half_length);
}

/// The distance of two segments, each a centre and a half: where one is fixed, the nearest place of the other is a
/// clamped projection, and a few turns between both settle (Ericson, Real-Time Collision Detection, 5.1.9).
double segment_distance(const Vec3& centre_a, const Vec3& half_a, const Vec3& centre_b, const Vec3& half_b) {
  const double aa = sim::dot(half_a, half_a), bb = sim::dot(half_b, half_b), ab = sim::dot(half_a, half_b);
  const Vec3 between = centre_b - centre_a;
  const double crossing = aa * bb - ab * ab;
  double s = 0, t = 0;
  if (crossing > 0) {
    s = std::clamp((sim::dot(between, half_a) * bb - sim::dot(between, half_b) * ab) / crossing, -1.0, 1.0);
  }
  const auto clamped = [](double part, double squared) {
    return squared > 0 ? std::clamp(part / squared, -1.0, 1.0) : 0;
  };
  t = clamped(ab * s - sim::dot(between, half_b), bb);
  s = clamped(ab * t + sim::dot(between, half_a), aa);
  t = clamped(ab * s - sim::dot(between, half_b), bb);
  return sim::length(Vec3(between + half_b * t - half_a * s));
}

double round_round(const Solid& a, const Solid& b) {
  const double apart = segment_distance(a.frame.position, segment_of(a), b.frame.position, segment_of(b));
  return largest(0.0, a.shape->radius + b.shape->radius - apart);
}

double sphere_box(const Solid& sphere, const Solid& box) {
  const Vec3 between = sphere.frame.position - box.frame.position;
  double outside = 0, inside = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double beyond = std::fabs(sim::dot(between, box.frame.axes[k])) - box.frame.half_extent[k];
    if (beyond > 0) outside += beyond * beyond;
    inside = std::min(inside, -beyond);
  }
  return largest(0.0, sphere.shape->radius + (outside > 0 ? -std::sqrt(outside) : inside));
}

/// The overlap of the projections on a direction of unit length, which points from a to b.
double overlap_along(const Solid& a, const Solid& b, const Vec3& direction) {
  return reach_of(a, direction) + reach_of(b, -direction) -
         sim::dot(Vec3(b.frame.position - a.frame.position), direction);
}

/// The least overlap over directions: axes of both, their cross products, the line of centres, and from the best of
/// these downhill.
class LeastOverlap {
 public:
  LeastOverlap(const Solid& a, const Solid& b) : a_(a), b_(b) {
    try_both(b.frame.position - a.frame.position);
    for (int i = 0; i < 3; ++i) {
      try_both(a.frame.axes[i]);
      try_both(b.frame.axes[i]);
      for (int j = 0; j < 3; ++j) try_both(sim::cross(a.frame.axes[i], b.frame.axes[j]));
    }
  }

  double find() {
    constexpr double kFirst = 0.5, kLast = 1e-8;  // rad
    for (double turn = kFirst; turn > kLast && least_ > 0;) {
      const Vec3 from = best_;
      const int thin = std::fabs(from.x()) < std::fabs(from.y()) ? 0 : 1;
      Vec3 one = sim::cross(from, thin == 0 ? Vec3(1, 0, 0) : Vec3(0, 1, 0));
      one = one / sim::length(one);
      const Vec3 other = sim::cross(from, one);
      const double before = least_;
      for (const Vec3& way : {one, Vec3(-one), other, Vec3(-other)}) look_along(from + way * turn);
      if (!(least_ < before)) turn /= 2;
    }
    return largest(0.0, least_);
  }

 private:
  void try_both(const Vec3& direction) {
    look_along(direction);
    look_along(-direction);
  }
  void look_along(const Vec3& direction) {
    const double size = sim::length(direction);
    if (!(size > 1e-6)) return;
    const Vec3 unit = direction / size;
    const double overlap = overlap_along(a_, b_, unit);
    if (!(overlap < least_)) return;
    least_ = overlap;
    best_ = unit;
  }

  const Solid& a_;
  const Solid& b_;
  double least_ = std::numeric_limits<double>::infinity();
  Vec3 best_ = {0, 0, 1};
};

struct Reach {
  Vec3 low, high;
};

Reach reach_around(const Solid& body) {
  Reach reach = {body.frame.position, body.frame.position};
  for (int k = 0; k < 3; ++k) {
    Vec3 along = {0, 0, 0};
    along[k] = 1;
    reach.high[k] += reach_of(body, along);
    reach.low[k] -= reach_of(body, -along);
  }
  return reach;
}

bool are_near(const Reach& a, const Reach& b) {
  for (int k = 0; k < 3; ++k) {
    if (a.low[k] > b.high[k] || b.low[k] > a.high[k]) return false;
  }
  return true;
}

}  // namespace

double reach_of(const Solid& body, const Vec3& direction) {
  const sim::BoxFrame& frame = body.frame;
  if (is_box(body)) {
    return frame.half_extent.x() * std::fabs(sim::dot(frame.axes[0], direction)) +
           frame.half_extent.y() * std::fabs(sim::dot(frame.axes[1], direction)) +
           frame.half_extent.z() * std::fabs(sim::dot(frame.axes[2], direction));
  }
  const Shape& shape = *body.shape;
  if (shape.kind == Kind::kSphere) return shape.radius;
  if (shape.kind == Kind::kCapsule || shape.kind == Kind::kCylinder) {
    const double along = std::fabs(sim::dot(axis_of(body), direction));
    const double across = shape.kind == Kind::kCapsule ? 1 : std::sqrt(largest(0.0, 1 - along * along));
    return shape.half_length * along + shape.radius * across;
  }
  const Vec3 own = sim::to_body(frame.axes, direction);
  double most = -std::numeric_limits<double>::infinity();
  for (const Vec3& point : shape.points) most = largest(most, sim::dot(point, own));
  return most;
}

double ground_penetration(const Solid& body) {
  return largest(0.0, reach_of(body, Vec3(0, 0, -1)) - body.frame.position.z());
}

bool overlap_is_exact(const Solid& a, const Solid& b) {
  if (is_box(a) && is_box(b)) return true;
  if (is_round(a) && is_round(b)) return true;
  return (is(a, Kind::kSphere) && is_box(b)) || (is_box(a) && is(b, Kind::kSphere));
}

double overlap_depth(const Solid& a, const Solid& b) {
  SIM_CHECK(!a.is_mesh() && !b.is_mesh());
  if (is_box(a) && is_box(b)) return overlap_depth(a.frame, b.frame);
  if (is_round(a) && is_round(b)) return round_round(a, b);
  if (is(a, Kind::kSphere) && is_box(b)) return sphere_box(a, b);
  if (is_box(a) && is(b, Kind::kSphere)) return sphere_box(b, a);
  return LeastOverlap(a, b).find();
}

// A sweep along x.
double deepest_overlap(std::span<const Solid> bodies, std::span<const std::uint8_t> left_out, bool& upper_bound) {
  SIM_CHECK(bodies.size() == left_out.size(), bodies.size(), left_out.size());
  std::vector<Reach> reaches;
  reaches.reserve(bodies.size());
  for (const Solid& body : bodies) reaches.push_back(reach_around(body));
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i].is_mesh()) order.push_back(i);
  }
  std::ranges::sort(order, {}, [&](std::size_t i) { return reaches[i].low.x(); });
  double deepest = 0;
  for (std::size_t first = 0; first < order.size(); ++first) {
    const std::size_t i = order[first];
    for (std::size_t second = first + 1; second < order.size(); ++second) {
      const std::size_t j = order[second];
      if (reaches[j].low.x() > reaches[i].high.x()) break;
      if ((left_out[i] != 0 && left_out[j] != 0) || !are_near(reaches[i], reaches[j])) continue;
      const double depth = overlap_depth(bodies[i], bodies[j]);
      upper_bound = upper_bound || (depth > 0 && !overlap_is_exact(bodies[i], bodies[j]));
      deepest = largest(deepest, depth);
    }
  }
  return deepest;
}

Vec3 inertia_of(const Shape& shape, double mass, const Vec3& size) {
  const double r = shape.radius, l = 2 * shape.half_length;
  double about = 0, across = 0;
  switch (shape.kind) {
    case Kind::kSphere:
      about = across = 0.4 * mass * r * r;
      break;
    case Kind::kCylinder:
      about = 0.5 * mass * r * r;
      across = mass * (3 * r * r + l * l) / 12;
      break;
    case Kind::kCapsule: {
      const double tube = l / (l + 4 * r / 3) * mass, caps = mass - tube;  // by volume, each over πr²
      about = tube * r * r / 2 + caps * 0.4 * r * r;
      across = tube * (l * l / 12 + r * r / 4) + caps * (0.4 * r * r + l * l / 4 + 3 * l * r / 8);
      break;
    }
    case Kind::kHull:
    case Kind::kMesh:
      return sim::box_inertia(mass, size);
  }
  Vec3 inertia = {across, across, across};
  inertia[shape.axis] = about;
  return inertia;
}

}  // namespace tumble::replay
