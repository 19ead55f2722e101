#include "src/layered/find/free_path.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "src/collide/box_pair.h"
#include "src/math/grid.h"
#include "src/world/free_flight.h"

namespace tumble::sim {
namespace {

constexpr double kTouching = 0.0001;  // m; the skin of contact_solve_impl.h
constexpr int kFollowMax = 1 << 20;   // a pass a millimetre away at the limits of size and spin takes some 10,000

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

// A time within which the two do not touch. Writes their separation.
double FreePaths::wait(const Flyer& a, const Flyer& b, double& separation) const {
  const auto along = [&](const Vec3& n) {
    const auto turning = [&](const Flyer& body) {
      return length(body.evenly ? cross(body.spin, n) : Vec3(body.spin * kSpinGrowth)) * body.radius;
    };
    const Vec3 approach = b.velocity - a.velocity;
    const double closing = (turning(a) + turning(b)) + (length(Vec3(b.gain - a.gain)) - dot(approach, n));
    return closing > 0 ? separation / closing : dt_;
  };
  if (a.row == kGround) {
    separation = b.frame.position.z() - reach_along(b.frame, 2);
    return along({0, 0, 1});
  }
  const BoxPair boxes(a.frame, b.frame);
  const BestAxes apart = boxes.best_of_all();
  separation = apart.separation;
  double longest = 0;
  for (unsigned rest = apart.axes; rest != 0; rest &= rest - 1) {
    longest = std::max(longest, along(boxes.normal(std::countr_zero(rest))));
  }
  return longest;
}

Approach FreePaths::follow(BodyIndex a, BodyIndex b, double margin) const {
  Flyer flyer_a = flyer(a), flyer_b = flyer(b);
  double time = 0, nearest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kFollowMax; ++k) {
    double separation = 0;
    const double next = wait(flyer_a, flyer_b, separation);
    if (separation <= kTouching) return {k > 0 ? Approach::Kind::kMeeting : Approach::Kind::kTouching, time};
    nearest = std::min(nearest, separation);
    if (time + next >= dt_) break;
    advance(flyer_a, time, next);
    advance(flyer_b, time, next);
    time += next;
  }
  return {nearest <= margin ? Approach::Kind::kNear : Approach::Kind::kPassing, 0};
}

}  // namespace tumble::sim
