#include "replay/import/table_notes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::uint64_t kStatesMin = 8;  // that say something of a session
constexpr double kFallMin = 0.1;         // m/s²
constexpr double kBeside = 0.02;         // of an acceleration along one axis: what may be beside it
constexpr std::size_t kDownZ = 4;        // −z, of the six ways

}  // namespace

void TableNotes::lost(const std::string& place, const NotFinite& found) {
  if (lost_.empty()) {
    first_lost_ = found;
    place_of_lost_ = place;
  }
  lost_.insert(found.body);
  first_lost_.bodies = lost_.size();
}

void TableNotes::rough_rotation(const std::string& place, sim::BodyId body, std::uint64_t step, double length) {
  if (++rough_ > 1) return;
  first_rough_ = place + "body " + std::to_string(body) + ", step " + std::to_string(step) +
                 ": the orientation is a quaternion of length " + significant(length, 9) + ", wanted 1";
}

void TableNotes::short_end(const std::string& place, std::size_t bodies, std::size_t before,
                           sim::BodyId first_missing) {
  short_end_ = place + "the last step has " + std::to_string(bodies) + " of the " + count_text(before, "body") +
               " of the step before; body " + std::to_string(first_missing) +
               (bodies + 1 < before ? " and others count" : " counts") + " as removed, unless the table was cut";
}

std::vector<std::string> TableNotes::texts() const {
  std::vector<std::string> out;
  if (!lost_.empty()) out.push_back(place_of_lost_ + to_string(first_lost_, {}));
  if (rough_ > 0) {
    out.push_back(first_rough_);
    if (rough_ > 1) out.back() += ", and " + count_text(rough_ - 1, "row") + " more likewise";
  }
  if (!short_end_.empty()) out.push_back(short_end_);
  if (back_ > 0) {
    out.push_back(first_back_);
    if (back_ > 1) out.back() += ", and " + count_text(back_ - 1, "return") + " more likewise";
  }
  return out;
}

void TableNotes::came_back(const std::string& place, sim::BodyId body, std::uint64_t step) {
  if (++back_ > 1) return;
  first_back_ = place + "body " + std::to_string(body) + " comes back in step " + std::to_string(step) +
                " after steps without it; the log removes it and throws it again";
}

// Bodies in free flight accelerate alike, whatever else a scene does, and nothing else accelerates steadily along one
// axis. So the axis along which most states accelerate, with no other acceleration beside it, is that of gravity.
void MotionCheck::look_at_fall(const sim::Vec3& change) {
  int axis = 0;
  for (int k = 1; k < 3; ++k) axis = std::fabs(change[k]) > std::fabs(change[axis]) ? k : axis;
  const double rest = std::fabs(change[(axis + 1) % 3]) + std::fabs(change[(axis + 2) % 3]);
  const double size = std::fabs(change[axis]);
  if (!(size > kFallMin) || !(rest < kBeside * size) || !std::isfinite(size)) return;
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

void MotionCheck::add(sim::BodyId body, std::uint64_t step, double dt, const EngineState& state, Told told,
                      const EngineAxes& axes) {
  constexpr double kSpeedMin = 0.5, kSpinMin = 0.5, kTurnMax = 1;  // m/s, rad/s, rad
  axes_ = axes;
  const auto [known, is_new] = before_.try_emplace(body);
  Before& before = known->second;
  const sim::Quat& q = state.orientation;
  if (is_new) {
    at_rest_ += std::fabs(q.w) == 1 ? 1U : 0U;
    scalar_last_ +=
        std::fabs(q.w) == 0 && (std::fabs(q.x) == 1 || std::fabs(q.y) == 1 || std::fabs(q.z) == 1) ? 1U : 0U;
  }
  const bool follows = !is_new && before.step + 1 == step && dt > 0;
  const sim::Vec3 moved = follows ? sim::Vec3(state.position - before.position) : sim::Vec3(0, 0, 0);
  if (follows && before.dt > 0) look_at_fall((moved / dt - before.moved / before.dt) / dt);
  if (follows && told.velocity) {
    const sim::Vec3 way = (state.velocity + before.velocity) * (dt / 2);
    const double speed = std::max(sim::length(state.velocity), sim::length(before.velocity));
    if (speed > kSpeedMin && sim::length(way) > 0.5 * speed * dt) velocities_.look(moved, way);
  }
  if (follows && told.spin) {
    const sim::Vec3 angle = (state.spin + before.spin) * (dt / 2);
    const sim::Quat& p = before.orientation;
    const sim::Quat turn = sim::product(q, {p.w, -p.x, -p.y, -p.z});
    const sim::Vec3 part = turn.w < 0 ? sim::Vec3(-turn.x, -turn.y, -turn.z) : sim::Vec3(turn.x, turn.y, turn.z);
    const double sine = sim::length(part), size = 2 * std::atan2(sine, std::fabs(turn.w));
    const sim::Vec3 turned = sine > 0 ? sim::Vec3(part * (size / sine)) : sim::Vec3(0, 0, 0);
    const double said = sim::length(angle), degrees = size > 0 ? said / size * std::numbers::pi / 180 : 0;
    const bool turns = said > kSpinMin * dt;
    if (turns && degrees > 0.9 && degrees < 1.1) ++degrees_;
    if (turns && said < kTurnMax) spins_.look(turned, angle);
    turns_ += turns ? 1U : 0U;
  }
  before = {step, follows ? dt : 0, state.position, state.velocity, moved, q, state.spin};
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
  const auto most = static_cast<std::size_t>(std::ranges::max_element(falls_) - falls_.begin());
  if (all < kStatesMin || 2 * falls_[most] <= all) return;
  const std::optional<std::size_t> wanted = down();
  const double told = axes_.their_metres(sim::length(gravity_));
  const bool slants = !wanted && told > 0;
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

void MotionCheck::add_to(std::vector<std::string>& out) const {
  add_fall(out);
  if (scalar_last_ > at_rest_ && scalar_last_ > 0) {
    out.push_back(
        "the first orientations of " + count_text(scalar_last_, "body") +
        " are half turns, 0 in w and 1 in another component; are the numbers of the quaternion in the order x "
        "y z w? wanted w x y z");
  }
  const auto add = [&out](const Fit& fit, const char* told, const char* moved, const char* remedy) {
    const std::uint64_t all = fit.against + fit.off + fit.fitting;
    const std::string of = " of " + std::to_string(all);
    if (fit.against >= kStatesMin && 2 * fit.against > all) {
      out.push_back(std::string("bodies ") + moved + " against their " + told + " in " +
                    count_text(fit.against, "state") + of + "; have the " + told + " the opposite sign?");
    } else if (fit.off >= kStatesMin && 2 * fit.off > all) {
      out.push_back(std::string("bodies ") + moved + ' ' + significant(fit.ratio, 3) +
                    " times as far in a step as their " + told + " say, in " + count_text(fit.off, "state") + of +
                    remedy);
    }
  };
  add(velocities_, "velocities", "move", "; is the unit of the velocities or dt another one?");
  if (degrees_ >= kStatesMin && 2 * degrees_ > turns_) {
    out.push_back("bodies turn 57.3 times less in a step than their spins say, in " + count_text(degrees_, "state") +
                  " of " + std::to_string(turns_) + "; are the spins in degrees/s? wanted rad/s");
  } else {
    add(spins_, "spins", "turn",
        "; is the unit of the spins or dt another one, or are spins about the body's own axes? wanted rad/s about the "
        "world's");
  }
}

void ContactCheck::add(std::uint64_t step, const std::vector<EngineContact>& contacts) {
  constexpr double kLengthOffMax = 1e-2;
  for (const EngineContact& contact : contacts) {
    const std::string place = "step " + std::to_string(step) + ", contact of " + std::to_string(contact.a) + " and " +
                              (contact.b == 0 ? "the world" : std::to_string(contact.b)) + ": ";
    const double where = contact.position.sum(), normal = sim::length(contact.normal);
    const std::array<std::pair<const char*, double>, 4> numbers = {
        {{"depth", contact.depth}, {"impulse", contact.impulse}, {"position", where}, {"normal", normal}}};
    const auto* const lost = std::ranges::find_if(numbers, [](const auto& one) { return !std::isfinite(one.second); });
    if (lost != numbers.end()) {
      if (++not_finite_ == 1) first_not_finite_ = place + lost->first + " is " + exact(lost->second);
    } else if (std::fabs(normal - 1) > kLengthOffMax) {
      if (++no_direction_ > 1) continue;
      first_no_direction_ = place + "the normal has a length of " + significant(normal, 3) + ", wanted 1";
    }
  }
}

std::string ContactCheck::text_of(const std::string& first, std::uint64_t count) {
  return count > 1 ? first + ", and " + std::to_string(count - 1) + " more likewise" : first;
}

}  // namespace tumble::replay
