#include "src/layered/find/free_path.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "src/collide/box_pair.h"
#include "src/kernels/box_tests.h"
#include "src/kernels/kernels_by_width.h"
#include "src/math/grid.h"
#include "src/world/free_flight.h"

namespace tumble::sim {
namespace {

constexpr double kTouchingSkin = 0.0001;  // m; the skin of contact_solve_impl.h
constexpr int kFollowMax = 1 << 20;       // a pass a millimetre away at the limits of size and spin takes some 10,000

constexpr double kRounding = 1e-6;  // more than the relative error of any bound, and m

// The spin of a box with different moments stays below the square root of 3 times its spin at any other time.
constexpr double kSpinGrowth = 1.75;

}  // namespace

// A body on its way. One that does not move has no velocity and no spin.
struct FreePaths::Flyer {
  BodyIndex row = kGround;
  bool moves = false, evenly = true;
  BoxFrame frame = {Vec3::Zero(), axes_of(Quat{}), Vec3::Zero()};
  Quat orientation;
  Vec3 spin = Vec3::Zero();
  Vec3 start = Vec3::Zero(), velocity = Vec3::Zero();  // m, m/s, at the start of the step
  Vec3 gain = Vec3::Zero();                            // m/s, until its end
  double radius = 0;
};

// Two bodies on their way.
struct FreePaths::Course {
  Flyer a, b;
  double margin = 0, time = 0, nearest = std::numeric_limits<double>::infinity();
  int advances = 0;
};

FreePaths::FreePaths(const WorldState& state, const Scratch& scratch, double dt_s)
    : state_(state), scratch_(scratch), dt_(dt_s) {}

double FreePaths::bend(BodyIndex a, BodyIndex b) const {
  const auto bent = [&](BodyIndex i) {
    if (i == kGround || !state_.bodies.moves(i)) return 0.0;
    return 0.5 * scratch_.turning[i] * (length(state_.bodies.spin[i]) * dt_);
  };
  return bent(a) + bent(b);
}

FreePaths::Flyer FreePaths::flyer(BodyIndex i) const {
  Flyer flyer;
  if (i == kGround) return flyer;
  const Bodies& bodies = state_.bodies;
  const WorldDef& def = state_.def;
  flyer.row = i;
  flyer.moves = bodies.moves(i);
  flyer.frame = scratch_.frames[i];
  flyer.orientation = bodies.orientation[i];
  flyer.start = flyer.frame.position;
  if (!flyer.moves) return flyer;
  flyer.evenly = turns_evenly(bodies.inertia[i]);
  flyer.velocity = bodies.velocity[i];
  flyer.spin = bodies.spin[i];
  flyer.gain = Vec3((flyer.velocity + def.gravity * dt_) / (1 + def.air_drag * dt_)) - flyer.velocity;
  flyer.radius = length(flyer.frame.half_extent);
  return flyer;
}

void FreePaths::advance(Flyer& flyer, double time_s, double by_s) const {
  if (!flyer.moves) return;
  const double now = time_s + by_s;
  const Vec3 path = flyer.velocity * now + flyer.gain * (0.5 * now * (now / dt_));
  flyer.frame.position = flyer.start + PositionGrid::round(path);
  if (dot(flyer.spin, flyer.spin) == 0) return;
  const Bodies& bodies = state_.bodies;
  const Rotation rotation =
      rotate_freely(flyer.orientation, flyer.spin, bodies.inertia[flyer.row], bodies.inverse_inertia[flyer.row], by_s);
  flyer.orientation = rotation.orientation;
  flyer.spin = rotation.spin;
  flyer.frame.axes = axes_of(flyer.orientation);
}

// A time within which the two do not touch. apart: the axes that keep them apart now.
double FreePaths::wait(const Flyer& a, const Flyer& b, const BestAxes& apart) const {
  const auto along = [&](const Vec3& n) {
    const auto turning = [&](const Flyer& body) {
      return length(body.evenly ? cross(body.spin, n) : Vec3(body.spin * kSpinGrowth)) * body.radius;
    };
    const Vec3 approach = b.velocity - a.velocity;
    const double closing = (turning(a) + turning(b)) + (length(Vec3(b.gain - a.gain)) - dot(approach, n));
    return closing > 0 ? apart.separation / closing : dt_;
  };
  if (a.row == kGround) return along({0, 0, 1});
  const Vec3 offset = b.frame.position - a.frame.position;
  double longest = 0;
  for (unsigned rest = apart.axes; rest != 0; rest &= rest - 1) {
    longest = std::max(longest, along(normal_along(a.frame, b.frame, offset, std::countr_zero(rest))));
  }
  return longest;
}

// Whether all corners of `other` are farther from a face of `body` in the end than the nearest is now. n: the face's
// normal, which turns with the body. As the face sees them, corners go straight but for what turns bend their ways, and
// the least distance of points that go straight is concave in time.
bool FreePaths::leaves(const Flyer& other, const Flyer& body, const Vec3& n) const {
  const Vec3 offset = other.frame.position - body.frame.position;
  const Vec3 velocity = (other.velocity - body.velocity) - cross(body.spin, offset), spin = other.spin - body.spin;
  double closer = 0;  // m, of the nearest corner in the end, beside the nearest of now, by turns
  for (int k = 0; k < 3; ++k) {
    const Vec3& axis = other.frame.axes[k];
    const double now = dot(axis, n), turned = now + dt_ * dot(cross(spin, axis), n);
    closer += other.frame.half_extent[k] * (std::fabs(turned) - std::fabs(now));
  }
  const double turning = length(body.spin), others = length(other.spin);
  const double bent =
      turning * (turning * (length(offset) + other.radius) + 2 * (length(velocity) + others * other.radius)) +
      others * (others * other.radius);
  const double fall = std::min(0.0, dot(Vec3(other.gain - body.gain), n));
  return dt_ * (dot(velocity, n) + 0.5 * fall) - closer - 0.5 * (dt_ * dt_) * bent > 0;
}

// Of two bodies that touch now.
Approach::Kind FreePaths::touching_or_parting(const Flyer& a, const Flyer& b, const BestAxes& apart) const {
  bool part = a.row == kGround && leaves(b, a, {0, 0, 1});
  for (int axis = 0; axis < 6; ++axis) {
    if ((apart.axes >> axis & 1U) == 0) continue;
    const Vec3 n = normal_along(a.frame, b.frame, b.frame.position - a.frame.position, axis);
    part |= axis < 3 ? leaves(b, a, n) : leaves(a, b, Vec3(-n));
  }
  return part ? Approach::Kind::kNear : Approach::Kind::kTouching;
}

// Moves both bodies as far as they surely do not touch; true: that was all, and `end` is what becomes of them.
bool FreePaths::go_on(Course& course, const BestAxes& apart, Approach& end) const {
  if (apart.separation <= kTouchingSkin) {
    end = {course.advances > 0 ? Approach::Kind::kMeeting : touching_or_parting(course.a, course.b, apart),
           course.time};
    return true;
  }
  course.nearest = std::min(course.nearest, apart.separation);
  const double next = wait(course.a, course.b, apart);
  if (course.time + next >= dt_ || course.advances == kFollowMax) {
    end = {course.nearest <= course.margin ? Approach::Kind::kNear : Approach::Kind::kPassing, 0};
    return true;
  }
  advance(course.a, course.time, next);
  advance(course.b, course.time, next);
  course.time += next;
  ++course.advances;
  return false;
}

FreePaths::Course FreePaths::course(BodyIndex a, BodyIndex b, double margin) const {
  Course course;
  course.a = flyer(a);
  course.b = flyer(b);
  course.margin = margin;
  return course;
}

Approach FreePaths::follow(BodyIndex a, BodyIndex b, double margin) const {
  Course on = course(a, b, margin);
  const auto apart = [&]() -> BestAxes {
    if (a == kGround) return {0, on.b.frame.position.z() - reach_along(on.b.frame, 2)};
    return BoxPair(on.a.frame, on.b.frame).best_of_all();
  };
  Approach end;
  while (!go_on(on, apart(), end)) continue;
  return end;
}

double FreePaths::way_most(BodyIndex a, BodyIndex b) const {
  const Bodies& bodies = state_.bodies;
  const auto turning = [&](BodyIndex i) {
    if (!bodies.moves(i)) return 0.0;
    return scratch_.turning[i] * (turns_evenly(bodies.inertia[i]) ? 1 : kSpinGrowth);
  };
  const auto velocity = [&](BodyIndex i) { return bodies.moves(i) ? bodies.velocity[i] : Vec3(Vec3::Zero()); };
  // Gravity gives both the same, but to a body that does not move; air drag takes a part from each.
  const double even = bodies.moves(a) && bodies.moves(b) ? 0 : length(state_.def.gravity) * dt_;
  const double speed = length(velocity(b) - velocity(a)) * (1 + state_.def.air_drag * dt_) + even;
  return (speed * dt_ + (turning(a) + turning(b))) * (1 + kRounding) + kRounding;
}

// What go_on tells of two bodies before it moves them. Returns the number of queries that are left.
std::size_t FreePaths::leave_undecided(std::span<const Query> queries, const Query** undecided) const {
  BoxTests tests;
  tests.frames = scratch_.frames.data();
  for (const Query& of : queries) {
    const std::size_t k = tests.count++;
    tests.a[k] = of.a;
    tests.b[k] = of.b;
    const Vec3 offset = scratch_.frames[of.b].position - scratch_.frames[of.a].position;
    for (int axis = 0; axis < 3; ++axis) tests.offset[axis][k] = offset[axis];
  }
  kernels(scratch_.lanes).box_tests.find_best(tests);
  std::size_t left = 0;
  for (std::size_t k = 0; k < queries.size(); ++k) {
    const Query& of = queries[k];
    const double separation = tests.all.separation[k];
    if (separation <= kTouchingSkin) {
      const BestAxes apart = {static_cast<AxisSet>(tests.all.axes[k]), separation};
      *of.approach = {touching_or_parting(flyer(of.a), flyer(of.b), apart), 0};
    } else if (separation > way_most(of.a, of.b)) {
      *of.approach = {separation <= of.margin ? Approach::Kind::kNear : Approach::Kind::kPassing, 0};
    } else {
      undecided[left++] = &of;
    }
  }
  return left;
}

void FreePaths::follow_all(std::span<const Query> queries) const {
  constexpr std::size_t kMost = 4 * BoxTests::kMost;
  std::array<const Query*, kMost> undecided;
  for (std::size_t begin = 0; begin < queries.size(); begin += kMost) {
    const std::size_t end = std::min(queries.size(), begin + kMost);
    std::size_t left = 0;
    for (std::size_t k = begin; k < end; k += BoxTests::kMost) {
      left += leave_undecided(queries.subspan(k, std::min(BoxTests::kMost, end - k)), undecided.data() + left);
    }
    follow_undecided(std::span(undecided).first(left));
  }
}

// A pair that is done makes room for the next one, so that the lanes stay full.
void FreePaths::follow_undecided(std::span<const Query* const> queries) const {
  constexpr std::size_t kAtOnce = 16;
  static_assert(kAtOnce <= BoxTests::kMost);
  const BoxTestKernels& box_tests = kernels(scratch_.lanes).box_tests;
  std::array<Course, kAtOnce> courses;
  std::array<const Query*, kAtOnce> query{};
  std::array<BoxFrame, 2 * kAtOnce> frames;
  BoxTests tests;
  tests.frames = frames.data();
  std::size_t next = 0;
  const auto fill = [&](std::size_t k) {
    query[k] = queries[next++];
    courses[k] = course(query[k]->a, query[k]->b, query[k]->margin);
  };
  for (; tests.count < kAtOnce && next < queries.size(); ++tests.count) fill(tests.count);
  while (tests.count > 0) {
    for (std::size_t k = 0; k < tests.count; ++k) {
      const Course& on = courses[k];
      const auto row = static_cast<std::uint32_t>(2 * k);
      tests.a[k] = row;
      tests.b[k] = row + 1;
      frames[row] = on.a.frame;
      frames[row + 1] = on.b.frame;
      const Vec3 offset = on.b.frame.position - on.a.frame.position;
      for (int axis = 0; axis < 3; ++axis) tests.offset[axis][k] = offset[axis];
    }
    box_tests.find_best(tests);
    for (std::size_t k = tests.count; k-- > 0;) {
      const BestAxes apart = {static_cast<AxisSet>(tests.all.axes[k]), tests.all.separation[k]};
      if (!go_on(courses[k], apart, *query[k]->approach)) continue;
      if (next < queries.size()) {
        fill(k);
      } else if (--tests.count != k) {
        courses[k] = courses[tests.count];
        query[k] = query[tests.count];
      }
    }
  }
}

}  // namespace tumble::sim
