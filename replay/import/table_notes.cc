#include "replay/import/table_notes.h"

#include <algorithm>
#include <cmath>

#include "src/base/text.h"

namespace tumble::replay {

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
  add_motion(out);
  return out;
}

void TableNotes::came_back(const std::string& place, sim::BodyId body, std::uint64_t step) {
  if (++back_ > 1) return;
  first_back_ = place + "body " + std::to_string(body) + " comes back in step " + std::to_string(step) +
                " after steps without it; the log removes it and throws it again";
}

// Bodies in free flight accelerate alike, whatever else a scene does, and nothing else accelerates steadily along one
// axis. So the axis along which most rows accelerate, with no other acceleration beside it, is that of gravity.
void TableNotes::motion(sim::BodyId body, std::uint64_t step, double dt, const EngineState& state, bool has_velocity,
                        const EngineAxes& axes) {
  axes_ = axes;
  const auto [known, is_new] = before_.try_emplace(body);
  Before& before = known->second;
  if (is_new) {
    const sim::Quat& q = state.orientation;
    at_rest_ += std::fabs(q.w) == 1 ? 1U : 0U;
    scalar_last_ +=
        std::fabs(q.w) == 0 && (std::fabs(q.x) == 1 || std::fabs(q.y) == 1 || std::fabs(q.z) == 1) ? 1U : 0U;
  }
  const bool follows = !is_new && before.step + 1 == step && dt > 0;
  const sim::Vec3 moved = follows ? sim::Vec3(state.position - before.position) : sim::Vec3(0, 0, 0);
  if (follows && before.dt > 0) {
    const sim::Vec3 change = (moved / dt - before.moved / before.dt) / dt;
    int axis = 0;
    for (int k = 1; k < 3; ++k) axis = std::fabs(change[k]) > std::fabs(change[axis]) ? k : axis;
    const double rest = std::fabs(change[(axis + 1) % 3]) + std::fabs(change[(axis + 2) % 3]);
    const double size = std::fabs(change[axis]);
    if (size > 0.1 && rest < 0.02 * size && std::isfinite(size)) {
      ++falls_[2 * static_cast<std::size_t>(axis) + (change[axis] > 0 ? 1 : 0)];
      ++sizes_[static_cast<int>(std::lround(10 * std::log10(size)))];
    }
  }
  if (follows && has_velocity) {
    const double way = sim::length(moved), told = sim::length(sim::Vec3((state.velocity + before.velocity) * (dt / 2)));
    const double speed = std::max(sim::length(state.velocity), sim::length(before.velocity));
    if (speed > 0.5 && std::isfinite(way) && std::isfinite(told) && told > 0.5 * speed * dt) {
      const double ratio = way / told;
      ++(ratio > 2 ? far_ : (ratio < 0.5 ? near_ : fitting_));
      if ((ratio > 2 || ratio < 0.5) && ratio_ == 0) ratio_ = ratio;
    }
  }
  before = {step, follows ? dt : 0, state.position, state.velocity, moved};
}

void TableNotes::add_motion(std::vector<std::string>& out) const {
  constexpr std::uint64_t kRowsMin = 8;  // that say something of a session
  std::uint64_t all = 0;
  for (const std::uint64_t count : falls_) all += count;
  const auto most = static_cast<std::size_t>(std::ranges::max_element(falls_) - falls_.begin());
  if (all >= kRowsMin && 2 * falls_[most] > all && most != 4) {
    const EngineAxis along = axes_.along(static_cast<int>(most / 2));
    const bool up = (most % 2 == 1) == (along.sign > 0);
    out.push_back(std::string("bodies in free flight accelerate along ") + (up ? "+" : "-") + along.letter +
                  " of the table in " + count_text(falls_[most], "row") + " of " + std::to_string(all) +
                  ", but its axes are " + to_string(axes_) + "; is a key \"up\" missing?");
  }
  const auto size = std::ranges::max_element(sizes_, {}, [](const auto& entry) { return entry.second; });
  if (all >= kRowsMin && size != sizes_.end() && 2 * size->second > all && (size->first > 17 || size->first < 0)) {
    out.push_back("bodies in free flight accelerate by about " + significant(std::pow(10, 0.1 * size->first), 2) +
                  " m/s^2, wanted about 9.81 on Earth; is the key \"length\" or \"dt\" another one?");
  }
  if (scalar_last_ > at_rest_ && scalar_last_ > 0) {
    out.push_back(
        "the first orientations of " + count_text(scalar_last_, "body") +
        " are half turns, 0 in w and 1 in another component; are the columns of the quaternion in the order x y z w?");
  }
  if (far_ + near_ >= kRowsMin && far_ + near_ > fitting_) {
    out.push_back("bodies move " + significant(ratio_, 3) + " times as far in a step as their velocities say, in " +
                  count_text(far_ + near_, "row") + " of " + std::to_string(far_ + near_ + fitting_) +
                  "; is the unit of the velocities or dt another one?");
  }
}

}  // namespace tumble::replay
