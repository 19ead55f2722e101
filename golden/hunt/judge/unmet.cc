#include "golden/hunt/judge/unmet.h"

#include <algorithm>
#include <cmath>

#include "golden/hunt/judge/mechanics.h"
#include "replay/measure/measure_overlap.h"
#include "src/world/free_flight.h"

namespace tumble::hunt {
namespace {

using sim::Bodies;
using sim::BodyIndex;
using sim::length;
using sim::Vec3;

constexpr int kSamplesMost = 192;

/// A step's bodies as they fly if nothing meets.
class Flights {
 public:
  /// dt: of the flights, s.
  Flights(const sim::WorldState& begun, double dt) : state_(begun), bodies_(begun.bodies), dt_(dt) {
    for (BodyIndex i = 0; i < bodies_.size(); ++i) {
      const Vec3 moments = moments_of(bodies_, i);
      reach_.push_back(half_diagonal(bodies_, i));
      // No turn is faster than all energy about the axis of the least moment.
      turn_.push_back(bodies_.moves(i) ? std::sqrt(2 * spin_energy(bodies_, i) / moments.minCoeff()) : 0);
      fall_.push_back(bodies_.moves(i) ? length(begun.def.gravity) * dt : 0);  // m/s gained
    }
  }

  [[nodiscard]] bool clear_of_ground(BodyIndex i) const {
    if (!state_.def.ground) return true;
    const double z = bodies_.position.z[i], speed = std::fabs(bodies_.velocity.z[i]) + fall_[i];
    if (z - reach_[i] - speed * dt_ > kNear) return true;
    const double motion = (speed + turn_[i] * reach_[i]) * dt_;
    return samples_clear(motion, bodies_.half_extent[i].minCoeff(), [&](double time) {
      const sim::BoxFrame frame = at(i, time);
      return frame.position.z() - sim::reach_along(frame, 2);
    });
  }

  [[nodiscard]] bool clear_of(BodyIndex i, BodyIndex j) const {
    const double apart = length(bodies_.position[j] - bodies_.position[i]) - reach_[i] - reach_[j];
    const Vec3 vi = bodies_.moves(i) ? bodies_.velocity[i] : Vec3(0, 0, 0);
    const Vec3 vj = bodies_.moves(j) ? bodies_.velocity[j] : Vec3(0, 0, 0);
    const double speed = length(vj - vi) + std::fabs(fall_[i] - fall_[j]);
    if (apart - speed * dt_ > kNear) return true;
    const double motion = (speed + turn_[i] * reach_[i] + turn_[j] * reach_[j]) * dt_;
    const double least = std::min(bodies_.half_extent[i].minCoeff(), bodies_.half_extent[j].minCoeff());
    return samples_clear(motion, least, [&](double time) { return replay::separation_of(at(i, time), at(j, time)); });
  }

  /// Whether i stays clear of a body that may be pushed anywhere.
  [[nodiscard]] bool far_from(BodyIndex i, BodyIndex j, const Bodies& after) const {
    const double apart = length(bodies_.position[j] - bodies_.position[i]) - reach_[i] - reach_[j];
    double speed = length(bodies_.velocity[j]);
    if (const auto now = after.find(bodies_.id[j])) speed = std::max(speed, length(after.velocity[*now]));
    const double others = 4 * (speed + fall_[j]) + length(bodies_.velocity[i]) + fall_[i];
    return apart - others * dt_ > 0.5 * reach_[j] + kNear;
  }

 private:
  [[nodiscard]] sim::BoxFrame at(BodyIndex i, double time) const {
    if (!bodies_.moves(i) || time == 0) return frame_of(bodies_, i);
    const Vec3 moments = moments_of(bodies_, i);
    const sim::Rotation turned = sim::rotate_freely(bodies_.orientation[i], bodies_.spin[i], moments,
                                                    {1 / moments.x(), 1 / moments.y(), 1 / moments.z()}, time);
    const Vec3 place = bodies_.position[i] + (bodies_.velocity[i] + state_.def.gravity * (0.5 * time)) * time;
    return {place, axes_of(turned.orientation), bodies_.half_extent[i]};
  }

  // Whether a distance stays positive over the step: at each sample it is more than what half the time to the next
  // sample can take away.
  template <class Distance>
  [[nodiscard]] bool samples_clear(double motion, double least, Distance distance) const {
    const double wanted = motion / (0.02 * least);
    if (!(wanted <= kSamplesMost)) return false;
    const int samples = std::max(2, static_cast<int>(std::ceil(wanted)));
    for (int k = 0; k <= samples; ++k) {
      const double slack = 0.5 * motion / samples + kNear;
      if (!(distance(dt_ * k / samples) > slack)) return false;
    }
    return true;
  }

  const sim::WorldState& state_;
  const Bodies& bodies_;
  double dt_;
  std::vector<double> reach_, turn_, fall_;  // m; rad/s; m/s
};

}  // namespace

namespace {

struct Meetings {
  std::vector<std::uint8_t> met;  // by row: may meet something, or does not move
  std::vector<Meeting> pairs;
};

// every: pairs of two bodies that meet others anyway, too.
Meetings meetings_of(const Trace& trace, std::size_t k, bool every) {
  const sim::WorldState& begun = trace.begun(k);
  const Bodies& bodies = begun.bodies;
  // The last sweep of method layered already stops what would meet in the substep to come. A substep moves bodies with
  // their speed at its end, so they fall a little farther than on a parabola.
  const bool layered = begun.def.method == sim::Method::kLayered;
  const Flights flights(begun, trace.steps[k].dt * (layered ? 1 + 2.0 / begun.def.substeps : 1));
  Meetings out;
  out.met.resize(bodies.size());
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    out.met[i] = bodies.moves(i) ? 0 : 1;
    if (!bodies.moves(i) || flights.clear_of_ground(i)) continue;
    out.pairs.emplace_back(kGroundId, bodies.id[i]);
    out.met[i] = 1;
  }
  const auto meet = [&](BodyIndex i, BodyIndex j) {
    out.pairs.emplace_back(std::min(bodies.id[i], bodies.id[j]), std::max(bodies.id[i], bodies.id[j]));
    out.met[i] = out.met[j] = 1;
  };
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    for (BodyIndex j = i + 1; j < bodies.size(); ++j) {
      if (!bodies.moves(i) && !bodies.moves(j)) continue;
      if (!every && out.met[i] != 0 && out.met[j] != 0) continue;
      if (!flights.clear_of(i, j)) meet(i, j);
    }
  }
  // A body that may meet something may be thrown at a third one.
  for (bool changed = true; changed;) {
    changed = false;
    for (BodyIndex i = 0; i < bodies.size(); ++i) {
      for (BodyIndex j = 0; out.met[i] == 0 && j < bodies.size(); ++j) {
        if (out.met[j] == 0 || bodies.is_static[j] != 0 || flights.far_from(i, j, trace.after(k).bodies)) continue;
        meet(i, j);
        changed = true;
      }
    }
  }
  return out;
}

}  // namespace

std::vector<std::uint8_t> surely_unmet(const Trace& trace, std::size_t k) {
  std::vector<std::uint8_t> unmet = meetings_of(trace, k, false).met;
  for (std::uint8_t& one : unmet) one = one == 0 ? 1 : 0;
  return unmet;
}

std::vector<Meeting> may_have_met(const Trace& trace, std::size_t k) {
  std::vector<Meeting> pairs = meetings_of(trace, k, true).pairs;
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace tumble::hunt
