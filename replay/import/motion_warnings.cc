// What the check of a session's motion says.
#include <algorithm>
#include <cmath>
#include <utility>

#include "replay/import/motion_check.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::uint64_t kOneIn = 500;     // states: fewer say nothing of a session
constexpr std::size_t kDownZ = 4;         // −z, of the six ways
constexpr std::uint64_t kAlsoFall = 4;    // times as many may accelerate along another axis
constexpr std::uint64_t kAlsoAtRest = 4;  // times as many first orientations may be 1 0 0 0

}  // namespace

/// −x, x, −y, y, −z, z: where the engine says that bodies fall to; none for a slanting gravity or none.
std::optional<std::size_t> MotionCheck::down() const {
  int axis = 0;
  for (int k = 1; k < 3; ++k) axis = std::fabs(gravity_[k]) > std::fabs(gravity_[axis]) ? k : axis;
  const double size = std::fabs(gravity_[axis]);
  if (!(size > 0) || sim::length(gravity_) > (1 + kBeside) * size) return std::nullopt;
  return 2 * static_cast<std::size_t>(axis) + (gravity_[axis] > 0 ? 1 : 0);
}

/// An engine with y up that forgets to say so tells a gravity along y of axes with z up: its motion fits its gravity,
/// and yet whatever is measured or drawn by height takes the wrong axis.
void MotionCheck::add_upright(std::vector<std::string>& out) const {
  const sim::Vec3& g = start_gravity_;
  int axis = 2;
  for (int k = 0; k < 2; ++k) axis = std::fabs(g[k]) > std::fabs(g[axis]) ? k : axis;
  if (g[axis] == 0 || (axis == 2 && g[axis] < 0)) return;
  const EngineAxis along = axes_.along(axis);
  out.push_back(std::string("gravity points along ") + ((g[axis] > 0) == (along.sign > 0) ? "+" : "-") + along.letter +
                ", but the axes are " + to_string(axes_) +
                (axis == 2 ? "; has \"gravity\" the opposite sign?" : "; is \"up\" missing, or another one?"));
}

void MotionCheck::add_fall(std::vector<std::string>& out) const {
  std::uint64_t all = 0;
  for (const std::uint64_t count : falls_) all += count;
  auto most = static_cast<std::size_t>(std::ranges::max_element(falls_) - falls_.begin());
  if (all < kStatesMin || 2 * falls_[most] <= all) return;
  const std::optional<std::size_t> wanted = down();
  const double told = axes_.their_metres(sim::length(gravity_));
  const bool slants = !wanted && told > 0;
  // Where bodies also fall as told, the axes are right.
  if (!slants && kAlsoFall * falls_[wanted.value_or(kDownZ)] >= falls_[most]) most = wanted.value_or(kDownZ);
  const auto size = std::ranges::max_element(sizes_[most], {}, [](const auto& entry) { return entry.second; });
  const double found = std::pow(10, 0.1 * size->first);  // m/s²
  const double off = told > 0 ? 10 * std::log10(found / sim::length(gravity_)) : 100;
  constexpr double kOffMax = 2.5;                     // in tenths of a decade: a factor of 1.8
  constexpr double kEarthLow = 0.8, kEarthHigh = 60;  // m/s²; what a game may have
  const bool is_aside = slants || most != wanted.value_or(kDownZ);
  if (is_aside && off < -kOffMax) return;  // friction and slopes accelerate less than gravity
  if (!slants && is_aside && (off <= kOffMax || told == 0)) {
    const EngineAxis along = axes_.along(static_cast<int>(most / 2));
    const bool up = (most % 2 == 1) == (along.sign > 0);
    out.push_back(std::string("bodies in free flight accelerate along ") + (up ? "+" : "-") + along.letter + " in " +
                  count_text(falls_[most], "state") + " of " + std::to_string(all) + ", but the axes are " +
                  to_string(axes_) + (wanted ? " and gravity has another direction" : "") +
                  "; is \"up\" missing, or another one, or \"gravity\"?");
    return;
  }
  if (2 * size->second <= falls_[most]) return;
  if (std::fabs(off) > kOffMax) {
    out.push_back("bodies in free flight accelerate by about " + significant(axes_.their_metres(found), 2) + ' ' +
                  axes_.unit() + "/s^2, but gravity is " + significant(told, 3) + ' ' + axes_.unit() +
                  "/s^2; is \"gravity\", \"dt\" or the unit of length another one?");
  } else if (found > kEarthHigh || found < kEarthLow) {
    out.push_back("bodies in free flight accelerate by about " + significant(found, 2) +
                  " m/s^2, wanted about 9.81 on Earth; is the unit of length or dt another one?");
  }
}

/// A warning where the numbers of quaternions stand in the order x y z w; else empty. Spins decide where they are told.
/// A table without spins in which all bodies turn about x from the start on is none that can be told: such numbers are
/// turns about z.
std::string MotionCheck::wrong_order() const {
  const char* const remedy =
      scalar_last_asked_
          ? "; --scalar-last was given, and the numbers of the quaternion look like w x y z: leave it out"
          : "; are the numbers of the quaternion in the order x y z w? wanted w x y z (name the columns by what they "
            "hold; arrays: --scalar-last, or scalar_last = true in [engine.table] of a tumble.toml)";
  const bool fits = order_.mostly_fits(), other_fits = other_order_.mostly_fits();  // both for turns about y
  if (fits && !other_fits) return "";
  if (other_fits && !fits) {
    return "bodies do not turn as their spins say, but would in " + count_text(other_order_.fitting, "state") + " of " +
           std::to_string(order_.all()) + " with another order of the numbers" + remedy;
  }
  if (scalar_last_ > kAlsoAtRest * at_rest_) {
    return "the first orientations of " + count_text(scalar_last_, "body") +
           " are half turns, 0 in w and 1 in another component" + remedy;
  }
  if (half_turns_ < kStatesMin || 2 * half_turns_ <= states_) return "";
  return "the orientations of " + count_text(half_turns_, "state") + " of " + std::to_string(states_) +
         " are half turns, 0 in w" + remedy;
}

std::string MotionCheck::leap_text(const NameOf& name_of) const {
  const std::string name = name_of ? name_of(leap_.body) : "";
  return "body " + std::to_string(leap_.body) + (name.empty() ? "" : " (" + in_quotes(name) + ")") + " moves by " +
         rounded(axes_.their_metres(leap_.way), axes_.unit()) + " in step " + std::to_string(leap_.step) +
         (leap_.is_back ? " and back in the next" : "") + ", and by at most " +
         rounded(axes_.their_metres(leap_.beside), axes_.unit()) + " in the steps beside " +
         (leap_.is_back ? "them" : "it") +
         (leaps_ > 1 ? ", and " + count_text(leaps_ - 1, "leap") + " more likewise" : "") +
         (leap_.is_back ? "; is the row of that step wrong?" : "; did the engine put it there, or is a row wrong?");
}

void MotionCheck::add_to(std::vector<std::string>& out, const NameOf& name_of) const {
  const std::size_t before = out.size();
  add_fall(out);
  if (out.size() == before) add_upright(out);
  const auto add = [&](const Fit& fit, const char* told, const char* moved, const char* remedy) {
    if (kOneIn * fit.all() < states_) return;
    const std::string of = " of " + std::to_string(fit.all());
    if (fit.against >= kStatesMin && 2 * fit.against > fit.all()) {
      out.push_back(std::string("bodies ") + moved + " against their " + told + " in " +
                    count_text(fit.against, "state") + of + "; have the " + told + " the opposite sign?");
    } else if (fit.off >= kStatesMin && 2 * fit.off > fit.all() && 2 * fit.aside > fit.off) {
      out.push_back(std::string("bodies ") + moved + " in another direction than their " + told + " say, as far, in " +
                    count_text(fit.aside, "state") + of + "; are the " + told +
                    " in the body's axes, wanted the world's, or are columns swapped?");
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
  if (leaps_ > 0) out.push_back(leap_text(name_of));
}

}  // namespace tumble::replay
