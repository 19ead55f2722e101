#include "replay/import/motion_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "replay/import/derived_motion.h"

namespace tumble::replay {
namespace {

constexpr double kFallMin = 0.1;   // m/s²
constexpr double kUnsteady = 0.1;  // of an acceleration: how much may change from step to step
constexpr double kAgainst = 0.98;  // of an acceleration: along the way that is slowed
constexpr double kLeap = 20;       // times as far as in the steps beside it
constexpr double kRadian = 180 / std::numbers::pi;

}  // namespace

// Bodies in free flight accelerate alike, whatever else a scene does, and nothing else accelerates steadily along one
// axis. So the axis along which most states accelerate, with no other acceleration beside it, is that of gravity.
// What bodies at rest do is neither steady nor much.
void MotionCheck::look_at_fall(const sim::Vec3& change, const sim::Vec3& before, const sim::Vec3& moved) {
  int axis = 0;
  for (int k = 1; k < 3; ++k) axis = std::fabs(change[k]) > std::fabs(change[axis]) ? k : axis;
  const double rest = std::fabs(change[(axis + 1) % 3]) + std::fabs(change[(axis + 2) % 3]);
  const double size = std::fabs(change[axis]);
  if (!(size > kFallMin) || !(rest < kBeside * size) || !std::isfinite(size)) return;
  if (!(sim::length(change - before) < kUnsteady * size)) return;
  // Friction slows what slides, against its way and across gravity, as steadily as gravity.
  const double across = std::fabs(sim::dot(change, gravity_)), along = sim::dot(change, moved);
  if (across < kBeside * size * sim::length(gravity_) && along < -kAgainst * size * sim::length(moved)) return;
  const std::size_t way = 2 * static_cast<std::size_t>(axis) + (change[axis] > 0 ? 1 : 0);
  ++falls_[way];
  ++sizes_[way][static_cast<int>(std::lround(10 * std::log10(size)))];
}

/// moved: in a step. told: what the motion that the engine gives says of it. Along it, so that the sign counts.
void MotionCheck::Fit::look(const sim::Vec3& moved, const sim::Vec3& told) {
  constexpr double kFar = 1.6, kNear = 0.62;  // beyond twice and half, with room for how an engine integrates
  const double found = sim::dot(moved, told) / sim::dot(told, told);
  if (!std::isfinite(found)) return;
  const bool is_against = found < -kNear;
  ++(is_against ? against : (found > kFar || found < kNear) ? off : fitting);
  if (is_against || (found <= kFar && found >= kNear)) return;
  const double size = sim::length(moved) / sim::length(told);
  if (size > kNear && size < kFar) {
    ++aside;
  } else if (ratio == 0) {
    ratio = size;
  }
}

bool MotionCheck::Fit::mostly_fits() const { return fitting >= kStatesMin && 2 * fitting > all(); }

/// The engine's four numbers in the order x y z w, where they were read as w x y z, or the other way round.
sim::Quat MotionCheck::in_other_order(const sim::Quat& ours) const {
  const sim::Quat read = axes_.their_turn(ours);
  return scalar_last_asked_ ? sim::Quat{read.x, read.y, read.z, read.w} : sim::Quat{read.z, read.w, read.x, read.y};
}

// Of numbers in the order x y z w, those of a body that is not turned read as a half turn about z, those of one that
// turns about y or z as half turns about a slanting axis. A body that faces backwards reads as one that is not turned
// too; other half turns, as of a body upside down, say nothing.
void MotionCheck::look_at_order(const sim::Quat& q, bool is_first) {
  const double other = std::fabs(in_other_order(q).w);
  if (q.w == 0 && other != 0 && other != 1) ++half_turns_;
  if (!is_first) return;
  if (std::fabs(q.w) == 1) ++at_rest_;
  if (q.w == 0 && other == 1) ++scalar_last_;
}

void MotionCheck::look_at_turn(const Before& before, const EngineState& state, double dt, bool is_quaternion) {
  constexpr double kSpinSeen = 0.05, kSpinMin = 0.5, kTurnMax = 1;  // rad/s, rad/s, rad
  const sim::Vec3 angle = (state.spin + before.spin) * (dt / 2);
  const double said = sim::length(angle);
  if (!(said > kSpinSeen * dt)) return;
  const sim::Vec3 turned = spin_between(before.orientation, state.orientation, 1);
  if (is_quaternion && said < kTurnMax) {
    order_.look(turned, angle);
    const auto other = [&](const sim::Quat& q) { return axes_.turn(in_other_order(q)); };
    other_order_.look(spin_between(other(before.orientation), other(state.orientation), 1), angle);
  }
  if (!(said > kSpinMin * dt)) return;
  ++turns_;
  const double size = sim::length(turned), degrees = size > 0 ? said / size / kRadian : 0;
  if (degrees > 0.9 && degrees < 1.1) ++degrees_;
  if (said < kTurnMax) spins_.look(turned, angle);
}

// A hit changes the ways of all steps behind it; what moves far in one step alone was put there. The way of the step
// before is judged now that the ways on both sides of it are known.
void MotionCheck::look_at_leap(sim::BodyId body, const Before& before, double way, double edge) {
  if (!before.way || !before.way_before) return;
  const double beside = std::max(*before.way_before, way);
  if (!std::isfinite(*before.way) || !(*before.way > edge) || !(*before.way > kLeap * beside)) return;
  if (++leaps_ == 1) leap_ = {body, before.step, *before.way, beside, false};
}

// A wrong row puts a body elsewhere for one step: both ways are long, and the second takes back the first.
void MotionCheck::look_at_leap_and_back(sim::BodyId body, const Before& before, double way, double edge) {
  if (!before.way || !before.way_before || !before.way_long_before) return;
  const double beside = std::max(*before.way_long_before, way), shorter = std::min(*before.way, *before.way_before);
  if (!std::isfinite(shorter) || !(shorter > edge) || !(shorter > kLeap * beside)) return;
  if (!(sim::length(before.moved + before.moved_before) < shorter / 2)) return;
  if (++leaps_ == 1) leap_ = {body, before.step - 1, *before.way_before, beside, true};
}

void MotionCheck::add(sim::BodyId body, std::uint64_t step, double dt, const EngineState& state, Told told, double edge,
                      const EngineAxes& axes) {
  constexpr double kSpeedMin = 0.5;  // m/s
  axes_ = axes;
  if (states_ == 0) start_gravity_ = gravity_;
  const auto [known, is_new] = before_.try_emplace(body);
  Before& before = known->second;
  ++states_;
  if (told.quaternion) look_at_order(state.orientation, is_new);
  const bool follows = !is_new && before.step + 1 == step && dt > 0;
  const sim::Vec3 moved = follows ? sim::Vec3(state.position - before.position) : sim::Vec3(0, 0, 0);
  std::optional<double> way;
  if (follows) way = sim::length(moved);
  if (way) {
    look_at_leap(body, before, *way, edge);
    look_at_leap_and_back(body, before, *way, edge);
  }
  std::optional<sim::Vec3> change;
  if (follows && before.dt > 0) change = (moved / dt - before.moved / before.dt) / dt;
  if (change && before.change) look_at_fall(*change, *before.change, moved);
  if (follows && told.velocity) {
    const sim::Vec3 said = (state.velocity + before.velocity) * (dt / 2);
    const double speed = std::max(sim::length(state.velocity), sim::length(before.velocity));
    if (speed > kSpeedMin && sim::length(said) > 0.5 * speed * dt) velocities_.look(moved, said);
  }
  if (follows && told.spin) look_at_turn(before, state, dt, told.quaternion);
  before = {step, follows ? dt : 0, state.position,    state.velocity, moved, state.orientation, state.spin,
            way,  before.way,       before.way_before, before.moved,   change};
}

}  // namespace tumble::replay
