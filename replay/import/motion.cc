#include "replay/import/motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "src/base/text.h"
#include "src/math/trig.h"

namespace tumble::replay {
namespace {

constexpr std::uint64_t kStatesMin = 8;  // that say something of a session
constexpr double kFallMin = 0.1;         // m/s²
constexpr double kBeside = 0.02;         // of an acceleration along one axis: what may be beside it
constexpr double kUnsteady = 0.1;        // of an acceleration: how much may change from step to step
constexpr std::uint64_t kOneIn = 500;    // states: fewer say nothing of a session
constexpr std::size_t kDownZ = 4;        // −z, of the six ways
constexpr std::uint64_t kAlsoFall = 4;   // times as many may accelerate along another axis
constexpr double kLeap = 20;             // times as far as in the steps beside it
constexpr double kRadian = 180 / std::numbers::pi;

/// The turn from one orientation to the next: along its axis, rad.
sim::Vec3 turn_between(const sim::Quat& p, const sim::Quat& q) {
  const sim::Quat turn = sim::product(q, {p.w, -p.x, -p.y, -p.z});
  const sim::Vec3 part = turn.w < 0 ? sim::Vec3(-turn.x, -turn.y, -turn.z) : sim::Vec3(turn.x, turn.y, turn.z);
  const double sine = sim::length(part), size = 2 * std::atan2(sine, std::fabs(turn.w));
  return sine > 0 ? sim::Vec3(part * (size / sine)) : sim::Vec3(0, 0, 0);
}

/// The orientation that the engine's four numbers give in the order x y z w, where they were read as w x y z.
sim::Quat as_scalar_last(const sim::Quat& ours, const EngineAxes& axes) {
  const sim::Quat read = axes.their_turn(ours);
  return axes.turn({read.z, read.w, read.x, read.y});
}

sim::Quat turn_after(const sim::Quat& a, const sim::Quat& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

sim::Quat turn_about(int axis, double degrees) {
  const sim::SinCos half = sim::sin_cos_degrees(degrees / 2);
  return {half.cos, axis == 0 ? half.sin : 0, axis == 1 ? half.sin : 0, axis == 2 ? half.sin : 0};
}

/// The angular velocity that turns one orientation to the other in dt: the shorter way.
sim::Vec3 spin_between(const sim::Quat& from, const sim::Quat& to, double dt) {
  sim::Quat turn = turn_after(to, {from.w, -from.x, -from.y, -from.z});
  if (turn.w < 0) turn = {-turn.w, -turn.x, -turn.y, -turn.z};
  const sim::Vec3 axis = {turn.x, turn.y, turn.z};
  const double sine = std::sqrt(axis.x() * axis.x() + axis.y() * axis.y() + axis.z() * axis.z());
  if (sine == 0) return {0, 0, 0};
  return axis * (2 * std::atan2(sine, turn.w) / (sine * dt));
}

}  // namespace

std::optional<EulerOrder> parse_euler(std::string_view text) {
  if (text.size() != 3) return std::nullopt;
  EulerOrder order;
  order.intrinsic = text[0] >= 'A' && text[0] <= 'Z';
  const char first = order.intrinsic ? 'X' : 'x';
  for (std::size_t k = 0; k < 3; ++k) {
    order.axes[k] = text[k] - first;
    if (order.axes[k] < 0 || order.axes[k] > 2 || (k > 0 && order.axes[k] == order.axes[k - 1])) return std::nullopt;
  }
  return order;
}

sim::Quat orientation_of(const EulerOrder& order, const std::array<double, 3>& degrees) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  sim::Quat q;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!std::isfinite(degrees[k])) return {kNaN, kNaN, kNaN, kNaN};
    const sim::Quat turn = turn_about(order.axes[k], degrees[k]);
    q = order.intrinsic ? turn_after(q, turn) : turn_after(turn, q);
  }
  return q;
}

void DerivedMotion::derive(sim::BodyId id, std::uint64_t step, double dt, bool velocity, bool spin,
                           EngineState& state) {
  const auto known = before_.find(id);
  if (known != before_.end() && known->second.step + 1 == step && dt > 0) {
    const Before& before = known->second;
    if (velocity) state.velocity = (state.position - before.position) / dt;
    if (spin) state.spin = spin_between(before.orientation, state.orientation, dt);
  }
  before_[id] = {step, state.position, state.orientation};
}

// Bodies in free flight accelerate alike, whatever else a scene does, and nothing else accelerates steadily along one
// axis. So the axis along which most states accelerate, with no other acceleration beside it, is that of gravity.
// What bodies at rest do is neither steady nor much.
void MotionCheck::look_at_fall(const sim::Vec3& change, const sim::Vec3& before) {
  int axis = 0;
  for (int k = 1; k < 3; ++k) axis = std::fabs(change[k]) > std::fabs(change[axis]) ? k : axis;
  const double rest = std::fabs(change[(axis + 1) % 3]) + std::fabs(change[(axis + 2) % 3]);
  const double size = std::fabs(change[axis]);
  if (!(size > kFallMin) || !(rest < kBeside * size) || !std::isfinite(size)) return;
  if (!(sim::length(change - before) < kUnsteady * size)) return;
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
  if (!is_against && (found > kFar || found < kNear) && ratio == 0) ratio = sim::length(moved) / sim::length(told);
}

bool MotionCheck::Fit::mostly_fits() const { return fitting >= kStatesMin && 2 * fitting > all(); }

// Of numbers in the order x y z w, those of a body that is not turned read as a half turn about z, those of one that
// turns about y or z as half turns about a slanting axis.
void MotionCheck::look_at_order(const sim::Quat& q, bool is_first) {
  const bool is_half = q.w == 0, is_along = std::max({std::fabs(q.x), std::fabs(q.y), std::fabs(q.z)}) == 1;
  if (is_half && !is_along) ++half_turns_;
  if (!is_first) return;
  if (std::fabs(q.w) == 1) ++at_rest_;
  if (is_half && is_along) ++scalar_last_;
}

void MotionCheck::look_at_turn(const Before& before, const EngineState& state, double dt, bool is_quaternion) {
  constexpr double kSpinMin = 0.5, kTurnMax = 1;  // rad/s, rad
  const sim::Vec3 angle = (state.spin + before.spin) * (dt / 2);
  const double said = sim::length(angle);
  if (!(said > kSpinMin * dt)) return;
  ++turns_;
  const sim::Vec3 turned = turn_between(before.orientation, state.orientation);
  const double size = sim::length(turned), degrees = size > 0 ? said / size / kRadian : 0;
  if (degrees > 0.9 && degrees < 1.1) ++degrees_;
  if (!(said < kTurnMax)) return;
  spins_.look(turned, angle);
  if (!is_quaternion) return;
  spins_of_scalar_last_.look(
      turn_between(as_scalar_last(before.orientation, axes_), as_scalar_last(state.orientation, axes_)), angle);
}

// A hit changes the ways of all steps behind it; what moves far in one step alone was put there. The way of the step
// before is judged now that the ways on both sides of it are known.
void MotionCheck::look_at_leap(sim::BodyId body, const Before& before, double way, double edge) {
  if (!before.way || !before.way_before) return;
  const double beside = std::max(*before.way_before, way);
  if (!std::isfinite(*before.way) || !(*before.way > edge) || !(*before.way > kLeap * beside)) return;
  if (++leaps_ == 1) leap_ = {body, before.step, *before.way, beside};
}

void MotionCheck::add(sim::BodyId body, std::uint64_t step, double dt, const EngineState& state, Told told, double edge,
                      const EngineAxes& axes) {
  constexpr double kSpeedMin = 0.5;  // m/s
  axes_ = axes;
  const auto [known, is_new] = before_.try_emplace(body);
  Before& before = known->second;
  ++states_;
  if (told.quaternion) look_at_order(state.orientation, is_new);
  const bool follows = !is_new && before.step + 1 == step && dt > 0;
  const sim::Vec3 moved = follows ? sim::Vec3(state.position - before.position) : sim::Vec3(0, 0, 0);
  std::optional<double> way;
  if (follows) way = sim::length(moved);
  if (way) look_at_leap(body, before, *way, edge);
  std::optional<sim::Vec3> change;
  if (follows && before.dt > 0) change = (moved / dt - before.moved / before.dt) / dt;
  if (change && before.change) look_at_fall(*change, *before.change);
  if (follows && told.velocity) {
    const sim::Vec3 said = (state.velocity + before.velocity) * (dt / 2);
    const double speed = std::max(sim::length(state.velocity), sim::length(before.velocity));
    if (speed > kSpeedMin && sim::length(said) > 0.5 * speed * dt) velocities_.look(moved, said);
  }
  if (follows && told.spin) look_at_turn(before, state, dt, told.quaternion);
  before = {step, follows ? dt : 0, state.position, state.velocity, moved, state.orientation, state.spin,
            way,  before.way,       change};
}

/// −x, x, −y, y, −z, z: where the engine says that bodies fall to; none for a slanting gravity or none.
std::optional<std::size_t> MotionCheck::down() const {
  int axis = 0;
  for (int k = 1; k < 3; ++k) axis = std::fabs(gravity_[k]) > std::fabs(gravity_[axis]) ? k : axis;
  const double size = std::fabs(gravity_[axis]);
  if (!(size > 0) || sim::length(gravity_) > (1 + kBeside) * size) return std::nullopt;
  return 2 * static_cast<std::size_t>(axis) + (gravity_[axis] > 0 ? 1 : 0);
}

void MotionCheck::add_fall(std::vector<std::string>& out) const {
  std::uint64_t all = 0;
  for (const std::uint64_t count : falls_) all += count;
  auto most = static_cast<std::size_t>(std::ranges::max_element(falls_) - falls_.begin());
  if (all < kStatesMin || 2 * falls_[most] <= all) return;
  const std::optional<std::size_t> wanted = down();
  const double told = axes_.their_metres(sim::length(gravity_));
  const bool slants = !wanted && told > 0;
  // Friction slows what slides as steadily as gravity; where bodies also fall as told, the axes are right.
  if (!slants && kAlsoFall * falls_[wanted.value_or(kDownZ)] >= falls_[most]) most = wanted.value_or(kDownZ);
  if (!slants && most != wanted.value_or(kDownZ)) {
    const EngineAxis along = axes_.along(static_cast<int>(most / 2));
    const bool up = (most % 2 == 1) == (along.sign > 0);
    out.push_back(std::string("bodies in free flight accelerate along ") + (up ? "+" : "-") + along.letter + " in " +
                  count_text(falls_[most], "state") + " of " + std::to_string(all) + ", but the axes are " +
                  to_string(axes_) + (wanted ? " and gravity has another direction" : "") +
                  "; is \"up\" missing, or another one, or \"gravity\"?");
    return;
  }
  const auto size = std::ranges::max_element(sizes_[most], {}, [](const auto& entry) { return entry.second; });
  if (2 * size->second <= falls_[most]) return;
  const double found = std::pow(10, 0.1 * size->first);  // m/s²
  const double off = sim::length(gravity_) > 0 ? std::fabs(10 * std::log10(found / sim::length(gravity_))) : 100;
  constexpr double kOffMax = 2.5;                     // in tenths of a decade: a factor of 1.8
  constexpr double kEarthLow = 0.8, kEarthHigh = 60;  // m/s²; what a game may have
  if (off > kOffMax) {
    out.push_back("bodies in free flight accelerate by about " + significant(axes_.their_metres(found), 2) + ' ' +
                  axes_.unit() + "/s^2, but gravity is " + significant(told, 3) + ' ' + axes_.unit() +
                  "/s^2; is \"gravity\", \"dt\" or the unit of length another one?");
  } else if (found > kEarthHigh || found < kEarthLow) {
    out.push_back("bodies in free flight accelerate by about " + significant(found, 2) +
                  " m/s^2, wanted about 9.81 on Earth; is the unit of length or dt another one?");
  }
}

/// A warning where the numbers of quaternions stand in the order x y z w; else empty. A table without spins in which
/// all bodies turn about x from the start on is none that can be told: such numbers are turns about z.
std::string MotionCheck::wrong_order() const {
  constexpr const char* kRemedy =
      "; are the numbers of the quaternion in the order x y z w? wanted w x y z (name the columns by what they hold; "
      "arrays: --scalar-last)";
  if (scalar_last_ > at_rest_) {
    return "the first orientations of " + count_text(scalar_last_, "body") +
           " are half turns, 0 in w and 1 in another component" + kRemedy;
  }
  if (half_turns_ >= kStatesMin && 2 * half_turns_ > states_) {
    return "the orientations of " + count_text(half_turns_, "state") + " of " + std::to_string(states_) +
           " are half turns, 0 in w" + kRemedy;
  }
  if (spins_.mostly_fits() || !spins_of_scalar_last_.mostly_fits()) return "";
  return "bodies do not turn as their spins say, but would in " + count_text(spins_of_scalar_last_.fitting, "state") +
         " of " + std::to_string(spins_.all()) + " with another order of the numbers" + kRemedy;
}

void MotionCheck::add_to(std::vector<std::string>& out) const {
  add_fall(out);
  const auto add = [&](const Fit& fit, const char* told, const char* moved, const char* remedy) {
    if (kOneIn * fit.all() < states_) return;
    const std::string of = " of " + std::to_string(fit.all());
    if (fit.against >= kStatesMin && 2 * fit.against > fit.all()) {
      out.push_back(std::string("bodies ") + moved + " against their " + told + " in " +
                    count_text(fit.against, "state") + of + "; have the " + told + " the opposite sign?");
    } else if (fit.off >= kStatesMin && 2 * fit.off > fit.all()) {
      out.push_back(std::string("bodies ") + moved + ' ' + significant(fit.ratio, 3) +
                    " times as far in a step as their " + told + " say, in " + count_text(fit.off, "state") + of +
                    remedy);
    }
  };
  add(velocities_, "velocities", "move", "; is the unit of the velocities or dt another one?");
  if (std::string order = wrong_order(); !order.empty()) {
    out.push_back(std::move(order));
  } else if (degrees_ >= kStatesMin && 2 * degrees_ > turns_) {
    out.push_back("bodies turn 57.3 times less in a step than their spins say, in " + count_text(degrees_, "state") +
                  " of " + std::to_string(turns_) +
                  "; are the spins in degrees/s, wanted rad/s, or columns euler in radians, wanted degrees or "
                  "'angles: radians'?");
  } else {
    add(spins_, "spins", "turn",
        "; is the unit of the spins or dt another one, or are spins about the body's own axes? wanted rad/s about the "
        "world's");
  }
  if (leaps_ == 0) return;
  out.push_back("body " + std::to_string(leap_.body) + " moves by " +
                rounded(axes_.their_metres(leap_.way), axes_.unit()) + " in step " + std::to_string(leap_.step) +
                ", and by at most " + rounded(axes_.their_metres(leap_.beside), axes_.unit()) +
                " in the steps beside it" +
                (leaps_ > 1 ? ", and " + count_text(leaps_ - 1, "leap") + " more likewise" : "") +
                "; did the engine put it there, or is a row wrong?");
}

}  // namespace tumble::replay
